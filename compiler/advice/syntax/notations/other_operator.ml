open Basis

let char_at text i = if i >= 0 && i < String.length text then text.[i] else '\000'
let sub text first last = String.sub text first (max 0 (last - first))

(* The offset after the bracket that closes the one at this offset, on the same line. *)
let closing text first =
  let rec go i depth =
    match char_at text i with
    | '\n' | '\000' -> None
    | '(' | '[' | '{' -> go (i + 1) (depth + 1)
    | ')' | ']' | '}' -> if depth = 1 then Some (i + 1) else go (i + 1) (depth - 1)
    | _ -> go (i + 1) depth
  in
  go first 0

(* {1 Negation} *)

let ends_an_application =
  [ "then"; "else"; "where"; "of"; "in"; "do"; "and"; "or"; "mod"; "div"; "if"; "is"; "not" ]

let rec name_end text i = if Character.is_name (char_at text i) then name_end text (i + 1) else i

(* A name with its fields, as in `i.speed`, or a number. *)
let rec path_end text i =
  let stop = name_end text i in
  if stop > i && char_at text stop = '.' && Character.is_name (char_at text (stop + 1)) then
    path_end text (stop + 1)
  else stop

let rec adjacent text stop =
  match char_at text stop with
  | '(' | '[' -> ( match closing text stop with Some stop -> adjacent text stop | None -> stop)
  | _ -> stop

(* The offset after the operand at this offset: a name, a literal, or an expression in brackets. *)
let operand text first =
  match char_at text first with
  | '(' | '[' -> closing text first
  | '"' -> Option.map succ (String.index_from_opt text (first + 1) '"')
  | c when Character.is_name c ->
      let stop = path_end text first in
      if List.mem (sub text first stop) ends_an_application then None else Some (adjacent text stop)
  | _ -> None

let application text first =
  let rec arguments stop =
    let rec blanks i = if char_at text i = ' ' then blanks (i + 1) else i in
    let next = blanks stop in
    match if next > stop then operand text next else None with
    | Some stop -> arguments stop
    | None -> stop
  in
  match operand text first with
  | None -> None
  | Some stop when Character.is_lower (char_at text first) -> Some (arguments stop)
  | Some stop -> Some stop

let negation text first =
  Option.map
    (fun stop ->
      let operand = sub text first stop in
      let operand = Option.value (Other_notation.expression operand) ~default:operand in
      ("not " ^ Source.grouped operand, stop))
    (application text first)

(* {1 Pipelines} *)

let is_pipe text i = char_at text i = '|' && char_at text (i + 1) = '>'

(* The start of the expression that contains this offset. *)
let start_of text at =
  let rec go i depth =
    if i = 0 then 0
    else
      match text.[i - 1] with
      | ')' | ']' | '}' -> go (i - 1) (depth + 1)
      | '(' | '[' | '{' -> if depth = 0 then i else go (i - 1) (depth - 1)
      | ',' when depth = 0 -> i
      | '=' when depth = 0 && char_at text (i - 2) = ' ' -> i
      | '>' when depth = 0 && char_at text (i - 2) = '-' -> i
      | '-' when depth = 0 && char_at text (i - 2) = '<' -> i
      | _ -> go (i - 1) depth
  in
  go at 0

(* The end of the expression that contains this offset; a line that begins with `|>` continues
   it. *)
let end_of text at =
  let rec blanks i = match char_at text i with ' ' | '\n' -> blanks (i + 1) | _ -> i in
  let rec go i depth =
    match char_at text i with
    | '\000' -> i
    | '\n' -> if is_pipe text (blanks i) then go (blanks i) depth else i
    | '(' | '[' | '{' -> go (i + 1) (depth + 1)
    | ')' | ']' | '}' -> if depth = 0 then i else go (i + 1) (depth - 1)
    | ',' when depth = 0 -> i
    | ' ' when depth = 0 && sub text i (min (String.length text) (i + 6)) = " where" -> i
    | _ -> go (i + 1) depth
  in
  go at 0

let rec split_pipes text first i depth =
  if i >= String.length text then [ sub text first i ]
  else if depth = 0 && is_pipe text i then sub text first i :: split_pipes text (i + 2) (i + 2) 0
  else
    let depth =
      match text.[i] with '(' | '[' | '{' -> depth + 1 | ')' | ']' | '}' -> depth - 1 | _ -> depth
    in
    split_pipes text first (i + 1) depth

let most_characters = 80

let pipeline text at =
  let first = start_of text at and last = end_of text at in
  if last - first > most_characters then None
  else
    match List.map String.trim (split_pipes (sub text first last) 0 0 0) with
    | first :: (_ :: _ as functions) when not (List.mem "" (first :: functions)) ->
        Some
          (List.fold_left
             (fun value f -> Printf.sprintf "%s %s" f (Source.grouped value))
             first functions)
    | _ -> None
