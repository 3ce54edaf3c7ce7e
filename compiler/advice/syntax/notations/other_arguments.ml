open Basis

let char_at text i = if i >= 0 && i < String.length text then text.[i] else '\000'

(* The offset of the bracket that closes the one at this offset. *)
let closing text first =
  let rec go i depth =
    match char_at text i with
    | '\000' -> None
    | '(' | '[' | '{' -> go (i + 1) (depth + 1)
    | ')' | ']' | '}' -> if depth = 1 then Some i else go (i + 1) (depth - 1)
    | _ -> go (i + 1) depth
  in
  go first 0

(* Splits the text at this separator, except inside brackets. *)
let split separator text =
  let rec go i from depth found =
    if i >= String.length text then
      List.rev (String.sub text from (String.length text - from) :: found)
    else
      match text.[i] with
      | '(' | '[' | '{' -> go (i + 1) from (depth + 1) found
      | ')' | ']' | '}' -> go (i + 1) from (depth - 1) found
      | c when c = separator && depth = 0 ->
          go (i + 1) (i + 1) 0 (String.sub text from (i - from) :: found)
      | _ -> go (i + 1) from depth found
  in
  List.map String.trim (go 0 0 0 [])

let is_name text =
  text <> "" && Character.is_lower text.[0] && String.for_all Character.is_name text

(* `1` for `x = 1` *)
let without_keyword argument =
  match String.index_opt argument '=' with
  | Some i when is_name (String.trim (String.sub argument 0 i)) ->
      String.trim (String.sub argument (i + 1) (String.length argument - i - 1))
  | Some _ | None -> argument

let without_keywords text opening =
  let open Basis.Let_syntax.Option in
  let rec start i = if Character.is_name (char_at text (i - 1)) then start (i - 1) else i in
  let name = String.sub text (start opening) (opening - start opening) in
  let* stop = closing text opening in
  let inside = String.sub text (opening + 1) (stop - opening - 1) in
  if String.contains inside '\n' || not (is_name name) then None
  else
    let arguments = List.map without_keyword (split ',' inside) in
    Other_notation.expression (Printf.sprintf "%s(%s)" name (String.concat ", " arguments))

let matrix text opening =
  let open Basis.Let_syntax.Option in
  let* stop = closing text opening in
  let inside = String.sub text (opening + 1) (stop - opening - 1) in
  let inside = String.map (function '\n' -> ' ' | c -> c) inside in
  let elements row =
    if String.contains row ',' then split ',' row else List.filter (( <> ) "") (split ' ' row)
  in
  let rows = List.filter (( <> ) []) (List.map elements (split ';' inside)) in
  let array elements = Printf.sprintf "[%s]" (String.concat ", " elements) in
  if String.length inside > 80 || List.length rows < 2 then None
  else if List.for_all (fun row -> List.length row = 1) rows then Some (array (List.concat rows))
  else Some (array (List.map array rows))
