open Basis

let sub text first last = String.sub text first (max 0 (last - first))

(* Splits the text at these separators, except inside brackets and quotes. *)
let split is_separator text =
  let n = String.length text in
  let rec go i depth quoted first parts =
    if i = n then List.rev (sub text first n :: parts)
    else
      match text.[i] with
      | '"' -> go (i + 1) depth (not quoted) first parts
      | _ when quoted -> go (i + 1) depth quoted first parts
      | '(' | '[' | '{' -> go (i + 1) (depth + 1) quoted first parts
      | ')' | ']' | '}' -> go (i + 1) (depth - 1) quoted first parts
      | c when depth = 0 && is_separator c ->
          go (i + 1) depth quoted (i + 1) (sub text first i :: parts)
      | _ -> go (i + 1) depth quoted first parts
  in
  List.filter (( <> ) "") (List.map String.trim (go 0 0 false 0 []))

let fields_of = split (fun c -> c = ',' || c = ';' || c = '\n')

let is_name text =
  text <> "" && Character.is_lower text.[0] && String.for_all Character.is_name text

let unquoted text =
  let n = String.length text in
  if n > 2 && text.[0] = '"' && text.[n - 1] = '"' then sub text 1 (n - 1) else text

let written value = Option.value (Other_notation.expression value) ~default:value

(* `x = 1` for `x: 1`, `"x": 1` or `.x = 1`, and `x = x` for a bare `x` that names both a field and
   a variable. *)
let field text =
  let named name value =
    let name = unquoted (String.trim name) and value = String.trim value in
    let n = String.length name in
    let name = if n > 1 && name.[0] = '.' then sub name 1 n else name in
    if is_name name && value <> "" then Some (Printf.sprintf "%s = %s" name (written value))
    else None
  in
  let at sign =
    match String.index_opt text sign with
    | Some i -> named (sub text 0 i) (sub text (i + 1) (String.length text))
    | None -> None
  in
  match at ':' with
  | Some field -> Some field
  | None -> ( match at '=' with Some field -> Some field | None -> named text text)

let braces record fields =
  match List.map field fields with
  | [] -> None
  | fields when List.mem None fields -> None
  | fields ->
      Some
        (Printf.sprintf "%s { %s }" (Source.grouped record)
           (String.concat ", " (List.filter_map Fun.id fields)))

let after_prefix text =
  let rest prefix =
    let n = String.length prefix in
    if String.starts_with ~prefix text && String.length text > n then
      Some (String.trim (sub text n (String.length text)))
    else None
  in
  List.find_map rest [ "..."; ".."; "**" ]

(* The record and the first field in `p | x = 1` and `p with x = 1`. *)
let record_and_field first =
  let n = String.length first in
  let word = " with " in
  let find i =
    if i >= n then None
    else if first.[i] = '|' && i > 0 && i + 1 < n && first.[i + 1] <> '|' && first.[i - 1] <> '|'
    then Some (sub first 0 i, sub first (i + 1) n)
    else if i + String.length word < n && sub first i (i + String.length word) = word then
      Some (sub first 0 i, sub first (i + String.length word) n)
    else None
  in
  List.find_map find (List.init n Fun.id)

let copied parts =
  match parts with
  | first :: rest when record_and_field first <> None ->
      let record, field = Option.get (record_and_field first) in
      Some (String.trim record, String.trim field :: rest)
  | _ -> (
      match List.partition (fun part -> after_prefix part <> None) parts with
      | [ record ], (_ :: _ as fields) ->
          Option.map (fun record -> (record, fields)) (after_prefix record)
      | _ -> None)

let most_characters = 80

(* The text in the braces, if it is short and not empty. *)
let inside text at =
  match Other_definition.in_braces text at with
  | Some (inside, _) when inside <> "" && String.length inside <= most_characters -> Some inside
  | Some _ | None -> None

(* The word directly before the braces. *)
let word_before text at =
  let rec blanks i = if i > 0 && text.[i - 1] = ' ' then blanks (i - 1) else i in
  let stop = blanks at in
  let rec start i =
    if i > 0 && (Character.is_name text.[i - 1] || text.[i - 1] = '.') then start (i - 1) else i
  in
  sub text (start stop) stop

let update text at =
  let is_record record = record <> "" && not (String.contains record '\n') in
  match Option.bind (inside text at) (fun inside -> copied (fields_of inside)) with
  | Some (record, fields) when is_record record -> (
      let updated = braces record fields in
      match word_before text at with
      (* an argument *)
      | word when is_name word && not (List.mem word [ "then"; "else"; "in"; "of"; "do"; "return" ])
        ->
          Option.map Source.grouped updated
      | _ -> updated)
  | Some _ | None -> None

let changed_copy text at =
  Option.map
    (Diagnostic.suggestion ~topic:Syntax_topic.Changed_copy
       "for a copy of the record with changed fields, write `%s`")
    (update text at)

let value text at =
  match word_before text at with
  | "" -> None
  | record when String.ends_with ~suffix:"." record -> None
  | record -> (
      match inside text at with
      | Some inside when String.contains inside ':' -> braces record (fields_of inside)
      | Some _ | None -> None)
