type t =
  | Null
  | Bool of bool
  | Int of int
  | Float of float
  | String of string
  | List of t list
  | Object of (string * t) list

let add_string buffer s =
  let n = String.length s in
  let rec go i =
    if i < n then
      match s.[i] with
      | '"' -> add "\\\"" i 1
      | '\\' -> add "\\\\" i 1
      | '\n' -> add "\\n" i 1
      | '\r' -> add "\\r" i 1
      | '\t' -> add "\\t" i 1
      | c when c < ' ' || c = '\127' -> add (Printf.sprintf "\\u%04x" (Char.code c)) i 1
      | c when c < '\127' ->
          Buffer.add_char buffer c;
          go (i + 1)
      | _ -> (
          match Utf8.decode s i with
          | 0, _ -> add "\u{fffd}" i 1
          | length, _ -> add (String.sub s i length) i length)
  and add text i length =
    Buffer.add_string buffer text;
    go (i + length)
  in
  Buffer.add_char buffer '"';
  go 0;
  Buffer.add_char buffer '"'

let rec add buffer = function
  | Null -> Buffer.add_string buffer "null"
  | Bool b -> Buffer.add_string buffer (string_of_bool b)
  | Int n -> Buffer.add_string buffer (string_of_int n)
  (* JSON cannot represent NaN or infinity. *)
  | Float x when not (Float.is_finite x) -> Buffer.add_string buffer "null"
  | Float x ->
      let short = Printf.sprintf "%.15g" x in
      let exact = if float_of_string short = x then short else Printf.sprintf "%.17g" x in
      Buffer.add_string buffer exact
  | String s -> add_string buffer s
  | List list ->
      Buffer.add_char buffer '[';
      List.iteri
        (fun i x ->
          if i > 0 then Buffer.add_char buffer ',';
          add buffer x)
        list;
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
