open Basis
open Text_place

(* The name before the bracket that contains this offset, such as `Float`. *)
let type_around text at =
  let rec bracket i =
    match char_at text i with
    | '[' -> Some i
    | ']' | '(' | ')' | '\n' | '\000' -> None
    | _ -> bracket (i - 1)
  in
  Option.bind
    (bracket (at - 1))
    (fun i ->
      let name = ending text i Character.is_name in
      if name <> "" && not (Character.is_digit name.[0]) then Some name else None)

let advice text at word =
  let start = line_start text at in
  let line = String.sub text start (end_of_line text start - start) in
  let first = List.hd (String.split_on_char ' ' (String.trim line)) in
  let is_free letter =
    (not (List.mem letter [ "m"; "s"; "g" ])) && find ("[" ^ letter ^ "]") line = None
  in
  let letter =
    Option.value (List.find_opt is_free [ String.sub word 0 1; "u"; "v"; "w" ]) ~default:"u"
  in
  match type_around text at with
  | Some name
    when find " :: " line <> None
         && (not (String.contains line '{'))
         && (is_a_name first || String.starts_with ~prefix:"(" first)
         && not (List.mem first [ "data"; "type"; "param"; "foreign" ]) ->
      let whole =
        String.trim (Option.fold (replaced ~name:word ~by:letter line) ~none:line ~some:snd)
      in
      let shown = if String.length whole < 80 then whole else Printf.sprintf "%s[%s]" name letter in
      Some (letter, Printf.sprintf "for any unit, write a single letter: `%s`" shown)
  | Some _ | None -> None
