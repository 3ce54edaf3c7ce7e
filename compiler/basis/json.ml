type t =
  | Null
  | Bool of bool
  | Int of int
  | Float of float
  | String of string
  | List of t list
  | Object of (string * t) list

(* Display replaces what is no UTF-8; line ends are kept. *)
let add_string buffer s =
  let clean = String.concat "\n" (List.map Display.sanitize (String.split_on_char '\n' s)) in
  Buffer.add_char buffer '"';
  String.iter
    (function
      | '"' -> Buffer.add_string buffer "\\\""
      | '\\' -> Buffer.add_string buffer "\\\\"
      | '\n' -> Buffer.add_string buffer "\\n"
      | c when c < ' ' -> Buffer.add_string buffer (Printf.sprintf "\\u%04x" (Char.code c))
      | c -> Buffer.add_char buffer c)
    clean;
  Buffer.add_char buffer '"'

let rec add buffer = function
  | Null -> Buffer.add_string buffer "null"
  | Bool b -> Buffer.add_string buffer (string_of_bool b)
  | Int n -> Buffer.add_string buffer (string_of_int n)
  | Float x ->
      let short = Printf.sprintf "%.15g" x in
      let exact = if float_of_string short = x then short else Printf.sprintf "%.17g" x in
      Buffer.add_string buffer exact
  | String s -> add_string buffer s
  | List list ->
      Buffer.add_char buffer '[';
      List.iteri (fun i x -> if i > 0 then Buffer.add_char buffer ','; add buffer x) list;
      Buffer.add_char buffer ']'
  | Object fields ->
      Buffer.add_char buffer '{';
      List.iteri
        (fun i (name, x) ->
          if i > 0 then Buffer.add_char buffer ',';
          add_string buffer name;
          Buffer.add_char buffer ':';
          add buffer x)
        fields;
      Buffer.add_char buffer '}'

let to_string t =
  let buffer = Buffer.create 1024 in
  add buffer t;
  Buffer.contents buffer
