type base =
  | Truth
  | Real of int
  | Whole of { bits : int; signed : bool }
  | Text
  | Message of { package : string; name : string }

type length = One | Exactly of int | At_most of int | Any
type field = { name : string; base : base; length : length; comment : string }
type constant = { constant : string; base : base; value : string }
type t = { fields : field list; constants : constant list }

let bases =
  [
    ("bool", Truth);
    ("float32", Real 32);
    ("float64", Real 64);
    ("int8", Whole { bits = 8; signed = true });
    ("uint8", Whole { bits = 8; signed = false });
    ("byte", Whole { bits = 8; signed = false });
    ("char", Whole { bits = 8; signed = false });
    ("int16", Whole { bits = 16; signed = true });
    ("uint16", Whole { bits = 16; signed = false });
    ("int32", Whole { bits = 32; signed = true });
    ("uint32", Whole { bits = 32; signed = false });
    ("int64", Whole { bits = 64; signed = true });
    ("uint64", Whole { bits = 64; signed = false });
    ("string", Text);
    ("wstring", Text);
  ]

let is_name text =
  let is_part = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false in
  text <> "" && String.for_all is_part text

(* Strings may have a maximum length: [string<=10]. *)
let without_bound text =
  match String.index_opt text '<' with Some k -> String.sub text 0 k | None -> text

let base ~package text =
  match (List.assoc_opt (without_bound text) bases, String.split_on_char '/' text) with
  | Some base, _ -> Some base
  | None, [ "Header" ] -> Some (Message { package = "std_msgs"; name = "Header" })
  | None, [ name ] when is_name name -> Some (Message { package; name })
  | None, ([ package; name ] | [ package; "msg"; name ]) when is_name package && is_name name ->
      Some (Message { package; name })
  | None, _ -> None

let length text =
  let number text =
    Option.bind (int_of_string_opt text) (fun n -> if n > 0 then Some n else None)
  in
  match text with
  | "" -> Some Any
  | bound when String.starts_with ~prefix:"<=" bound ->
      Option.map (fun n -> At_most n) (number (String.sub bound 2 (String.length bound - 2)))
  | size -> Option.map (fun n -> Exactly n) (number size)

(* A type, as in [geometry_msgs/Point[<=4]]. *)
let type_of ~package text =
  match String.index_opt text '[' with
  | None -> Option.map (fun base -> (base, One)) (base ~package text)
  | Some k when text.[String.length text - 1] = ']' -> (
      let inside = String.sub text (k + 1) (String.length text - k - 2) in
      match (base ~package (String.sub text 0 k), length inside) with
      | Some base, Some length -> Some (base, length)
      | _ -> None)
  | Some _ -> None

(* Splits a line into a type, a name, and the rest, which may be empty. [None] if there is only one
   word. *)
let words line =
  match Str.bounded_split (Str.regexp "[ \t]+") line 3 with
  | [ type_; name; rest ] -> Some (type_, name, rest)
  | [ type_; name ] -> Some (type_, name, "")
  | _ -> None

(* Splits off the comment, which begins at the first `#`, even if that is part of a string
   constant. *)
let apart line =
  match String.index_opt line '#' with
  | Some k ->
      ( String.trim (String.sub line 0 k),
        String.trim (String.sub line (k + 1) (String.length line - k - 1)) )
  | None -> (String.trim line, "")

let constant_of (type_, name, rest) =
  match String.index_opt name '=' with
  | Some k ->
      let value = String.sub name (k + 1) (String.length name - k - 1) in
      Some (type_, String.sub name 0 k, String.trim (value ^ " " ^ rest))
  | None when String.starts_with ~prefix:"=" rest ->
      Some (type_, name, String.trim (String.sub rest 1 (String.length rest - 1)))
  | None -> None

let parse ~package ~file text =
  let fault number line =
    Error (Printf.sprintf "%s:%d: neither a field nor a constant of a message: %s" file number line)
  in
  let rec read number above found = function
    | [] -> Ok { fields = List.rev found.fields; constants = List.rev found.constants }
    | line :: lines -> (
        let continue above found = read (number + 1) above found lines in
        match apart line with
        | "", "" -> continue [] found
        | "", comment -> continue (comment :: above) found
        | code, comment -> (
            match words code with
            | None -> fault number code
            | Some words -> (
                match constant_of words with
                | Some (type_, constant, value) -> (
                    match type_of ~package type_ with
                    | Some (base, One) when is_name constant ->
                        continue []
                          { found with constants = { constant; base; value } :: found.constants }
                    | Some _ | None -> fault number code)
                | None -> (
                    let type_, name, _ = words in
                    match type_of ~package type_ with
                    | Some (base, length) when is_name name ->
                        let above = String.concat " " (List.rev above) in
                        let comment = String.trim (comment ^ " " ^ above) in
                        continue []
                          { found with fields = { name; base; length; comment } :: found.fields }
                    | Some _ | None -> fault number code))))
  in
  read 1 [] { fields = []; constants = [] } (String.split_on_char '\n' text)

let base_text = function
  | Message { package; name } -> package ^ "/" ^ name
  | base -> fst (List.find (fun (_, other) -> other = base) bases)

let type_text (f : field) =
  base_text f.base
  ^
  match f.length with
  | One -> ""
  | Exactly n -> Printf.sprintf "[%d]" n
  | At_most n -> Printf.sprintf "[<=%d]" n
  | Any -> "[]"

let camel name =
  match List.filter (fun word -> word <> "") (String.split_on_char '_' name) with
  | [] -> name
  | first :: others -> String.concat "" (first :: List.map String.capitalize_ascii others)

let frob_name name =
  let name = camel name in
  if List.mem name Syntax.Lexer.keywords then name ^ "_" else name

let is_named name (f : field) =
  let own = camel f.name in
  String.equal name own || String.equal name (own ^ "_")
