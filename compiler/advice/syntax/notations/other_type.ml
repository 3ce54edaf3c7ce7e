open Basis

exception Unknown

let char_at text i = if i >= 0 && i < String.length text then text.[i] else '\000'

let without_namespace name =
  match String.rindex_opt name ':' with
  | Some i -> String.sub name (i + 1) (String.length name - i - 1)
  | None -> name

let is_number text = text <> "" && String.for_all Character.is_digit text

(* A type without arguments. *)
let simple name =
  match without_namespace name with
  | "double" | "float" | "float32" | "float64" -> "Float"
  | "int" | "long" | "unsigned" | "size_t" | "int32_t" | "uint8_t" -> "Int"
  | "bool" | "boolean" -> "Bool"
  | "string" | "str" -> "String"
  | "" -> raise Unknown
  | name when is_number name -> name
  | name -> String.capitalize_ascii name

let argument text = if String.contains text ' ' then "(" ^ text ^ ")" else text

let applied name arguments =
  let join = String.concat " " in
  match (String.lowercase_ascii (without_namespace name), arguments) with
  | ("array" | "vector" | "list" | "deque" | "sequence"), [ element ] ->
      join [ "Array"; "n"; argument element ]
  | ("array" | "vector" | "list" | "deque"), [ a; b ] when is_number a || is_number b ->
      let size, element = if is_number a then (a, b) else (b, a) in
      join [ "Array"; size; argument element ]
  | "optional", [ element ] -> join [ "Maybe"; argument element ]
  | ("function" | "unique_ptr" | "shared_ptr" | "ptr"), _ -> raise Unknown
  | _, _ -> join (simple name :: List.map argument arguments)

let is_part c = Character.is_name c || c = ':'
let rec blanks text i = if char_at text i = ' ' then blanks text (i + 1) else i

let rec type_at text start =
  let rec name i = if is_part (char_at text i) then name (i + 1) else i in
  let stop = name start in
  let word = String.sub text start (stop - start) in
  match char_at text stop with
  | '<' ->
      let arguments, stop = arguments text (stop + 1) in
      (applied word arguments, stop)
  | '[' -> (
      match String.index_from_opt text stop ']' with
      | Some last -> (simple word ^ String.sub text stop (last + 1 - stop), last + 1)
      | None -> raise Unknown)
  | _ -> (simple word, stop)

and arguments text at =
  let first, stop = type_at text (blanks text at) in
  match char_at text (blanks text stop) with
  | ',' ->
      let others, stop = arguments text (blanks text stop + 1) in
      (first :: others, stop)
  | '>' -> ([ first ], blanks text stop + 1)
  | _ -> raise Unknown

let in_angles text start =
  match type_at text start with
  | written, stop when char_at text (stop - 1) = '>' -> Some (written, stop)
  | _ -> None
  | exception Unknown -> None
