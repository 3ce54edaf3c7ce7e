open Basis
open Text_place

let type_of value =
  let inside =
    match (String.index_opt value '[', String.rindex_opt value ']') with
    | Some first, Some last when last = String.length value - 1 && first > 0 ->
        Some (String.sub value first (last - first + 1))
    | _ -> None
  in
  match (value, inside) with
  | ("True" | "False"), _ -> "Bool"
  | _, Some unit_ -> "Float" ^ unit_
  | _ -> "Float"

let declaration ~name value = Printf.sprintf "param %s :: %s = %s" name (type_of value) value

(* The name in quotes, which may begin with the `~` or `/` of ROS. *)
let name_of label =
  let is_part c = Character.is_name c in
  let rec start i =
    if i < String.length label && List.mem label.[i] [ '~'; '/' ] then start (i + 1) else i
  in
  let first = start 0 in
  let name = String.sub label first (String.length label - first) in
  let is_plain = name <> "" && Character.is_lower name.[0] && String.for_all is_part name in
  if not is_plain then None
  else
    match String.split_on_char '_' name with
    | first :: others when first <> "" ->
        Some (String.concat "" (first :: List.map String.capitalize_ascii others))
    | _ -> None

(* Is the text a number, with or without a unit, or a Boolean? *)
let is_a_value text =
  let count c = List.length (String.split_on_char c text) in
  text <> ""
  && (Character.is_digit text.[0] || text.[0] = '-' || text = "True" || text = "False")
  && count '[' = count ']'
  && not (String.exists (fun c -> List.mem c [ '"'; '('; ')'; ','; '='; '+' ]) text)

let of_arguments text at =
  let rec blanks i = if char_at text i = ' ' then blanks (i + 1) else i in
  let start = blanks at in
  let is_call = char_at text start = '(' in
  let start = if is_call then blanks (start + 1) else start in
  let quote = char_at text start in
  let open Basis.Let_syntax.Option in
  let* () = if quote = '"' || quote = '\'' then Some () else None in
  let* stop = String.index_from_opt text (start + 1) quote in
  let* name = name_of (String.sub text (start + 1) (stop - start - 1)) in
  let rest = String.sub text (stop + 1) (end_of_line text (stop + 1) - stop - 1) in
  let rest = String.trim (without_closing rest) in
  let rest =
    if rest <> "" && rest.[0] = ',' then String.trim (String.sub rest 1 (String.length rest - 1))
    else rest
  in
  let value = match rest with "true" -> "True" | "false" -> "False" | other -> other in
  Some (name, declaration ~name (if is_a_value value then value else "1"))

let defines text at name =
  let start = line_start text at in
  String.equal (String.trim (String.sub text start (at - start))) (name ^ " =")

let is_its_definition text at name =
  defines text at name && char_at text (line_start text at) <> ' '

let hint text at (name, declaration) =
  if is_its_definition text at name then
    Printf.sprintf "write `%s` in place of this equation" declaration
  else
    Printf.sprintf "declare the parameter as `%s` on its own line, at the left margin, and %s"
      declaration
      (if defines text at name then "remove this equation"
       else Printf.sprintf "write `%s` here" name)
