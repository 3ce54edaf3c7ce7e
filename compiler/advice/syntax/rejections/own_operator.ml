open Basis
open Text_place

let is_symbol c = String.contains "+-*/^=<>&|!.@:$%~#?" c
let lines text = List.map String.trim (String.split_on_char '\n' text)
let words line = List.filter (( <> ) "") (String.split_on_char ' ' line)

(* The parameters and the value of an equation that defines the operator. *)
let equation operator line =
  let of_value a b value = Some (a, b, String.concat " " value) in
  match words line with
  | a :: name :: b :: "=" :: value when String.equal name operator && is_a_name a && is_a_name b ->
      of_value a b value
  | name :: a :: b :: "=" :: value
    when String.equal name ("(" ^ operator ^ ")") && is_a_name a && is_a_name b ->
      of_value a b value
  | _ -> None

let is_defined text operator =
  let defines line =
    String.starts_with ~prefix:("(" ^ operator ^ ")") line
    || equation operator line <> None
    ||
    match words line with
    | _ :: name :: rest -> String.equal name operator && List.mem "=" rest
    | _ -> false
  in
  List.exists defines (lines text)

let defined text at =
  let rec first i = if is_symbol (char_at text (i - 1)) then first (i - 1) else i in
  let rec last i = if is_symbol (char_at text i) then last (i + 1) else i in
  let start = first at in
  let operator = String.sub text start (last at - start) in
  if String.length operator > 1 && is_defined text operator then Some (operator, start) else None

let advice text operator =
  let a, b, value =
    Option.value (List.find_map (equation operator) (lines text)) ~default:("a", "b", "…")
  in
  let is_short = value <> "" && String.length value <= 50 && find operator value = None in
  Printf.sprintf "define a function, such as `combine %s %s = %s`, and write ``%s `combine` %s``" a
    b
    (if is_short then value else "…")
    a b

(* The first line at the left margin at or above this offset. *)
let rec heading text start =
  match char_at text start with
  | (' ' | '\n' | '\r') when start > 0 -> heading text (line_start text (start - 1))
  | _ -> start

let is_in_an_instance ~text (at : Span.t) =
  let start = heading text (line_start text (offset text at.start)) in
  find ~from:start "instance " text = Some start

let built_in_class ~text (at : Span.t) =
  let offset = offset text at.start in
  let start = heading text (line_start text offset) in
  let line = String.sub text start (end_of_line text start - start) in
  let class_ =
    match words line with
    | "instance" :: rest when List.mem "=>" rest ->
        let rec head = function "=>" :: rest -> rest | _ :: rest -> head rest | [] -> [] in
        head rest
    | "instance" :: rest -> rest
    | _ -> []
  in
  match class_ with
  | (("Eq" | "Ord") as name) :: _ ->
      let lines = ref (Span.line at.start) in
      String.iter
        (fun c -> if c = '\n' then decr lines)
        (String.sub text start (max 0 (offset - start)));
      let place column = Span.position ~line:!lines ~column:(column + 1) in
      let stop = Option.value (find " where" line) ~default:(String.length line) in
      let head = { at with start = place (String.length "instance "); stop = place stop } in
      Some (name, head)
  | _ -> None
