open Basis
open Resolve

let declared_here (constructor : Interface.constructor) =
  Diagnostic.label ~at:constructor.span "declared here"

let name (constructor : Interface.constructor) = constructor.global.name
let quoted = List.map (Printf.sprintf "`%s`")
let all_fields known = Diagnostic.note "its fields: %s" (String.concat ", " (quoted known))

let unknown_field suggestions constructor ~known (field : Syntax.Ir.name) =
  Diagnostic.error ~code:"E0209" ~at:field.span "constructor `%s` has no field `%s`"
    (name constructor) field.text
  |> declared_here constructor
  |> Suggestion.add suggestions field.text (lazy known)
  |> fun d -> if d.hints = [] then all_fields known d else d

(* Reports several unknown fields in one message: the user probably meant another record. *)
let unknown_fields constructor ~known (first : Syntax.Ir.name) others =
  let texts = List.map (fun (field : Syntax.Ir.name) -> field.text) (first :: others) in
  Diagnostic.error ~code:"E0209" ~at:first.span "constructor `%s` has no fields %s"
    (name constructor)
    (Enumeration.all (quoted texts))
  |> declared_here constructor
  |>
  if List.compare_length_with known 8 <= 0 then
    Diagnostic.hint "its fields are `%s { %s }`" (name constructor)
      (String.concat ", " (List.map (Printf.sprintf "%s = …") known))
  else all_fields known

let wrong_number_of_arguments (constructor : Interface.constructor) ~found at =
  Diagnostic.error ~code:"E0225" ~at "constructor `%s` has %d argument%s, not %d" (name constructor)
    constructor.arity
    (if constructor.arity = 1 then "" else "s")
    found
  |> declared_here constructor
  |>
  if constructor.arity = 0 || constructor.arity > 3 then Fun.id
  else
    let letter i = String.make 1 (Char.chr (Char.code 'a' + i)) in
    Diagnostic.hint "its pattern is `%s %s`: write `_` for an argument that you do not use"
      (name constructor)
      (String.concat " " (List.init constructor.arity letter))

(* The field and a value for it, in backticks. *)
let with_value constructor field =
  match (name constructor, field) with
  | "Trial", "seeds" -> "``seeds = 1 `to` 10``"
  | _ -> Printf.sprintf "`%s = …`" field

(* The fix inserts the missing fields after the last one. Their values are `_`, which does not
   compile, so the user must fill them in. *)
let fields_missing constructor ~absent ~(last : Span.t option) at =
  Diagnostic.error ~code:"E0228" ~at "this `%s` is missing the field%s %s" (name constructor)
    (if List.length absent = 1 then "" else "s")
    (Enumeration.all (quoted absent))
  |> declared_here constructor
  |> Diagnostic.hint "give every field a value: add %s"
       (Enumeration.all (List.map (with_value constructor) absent))
  |>
  match last with
  | Some last ->
      let at = { last with start = last.stop } in
      let text = String.concat "" (List.map (Printf.sprintf ", %s = _") absent) in
      Diagnostic.fix "add the missing fields" [ (at, text) ]
  | None -> Fun.id

let diagnostic suggestions : Fact.in_records -> Diagnostic.t = function
  | Unknown_fields { constructor; known; first; others = [] } ->
      unknown_field suggestions constructor ~known first
  | Unknown_fields { constructor; known; first; others } ->
      unknown_fields constructor ~known first others
  | No_fields { constructor; at } ->
      Diagnostic.error ~code:"E0209" ~at "constructor `%s` has no named fields" (name constructor)
      |> declared_here constructor
  | Field_repeated { first; second } ->
      Diagnostic.error ~code:"E0213" ~at:second.span "field `%s` appears twice" second.text
      |> Diagnostic.label ~at:first.span "first used here"
  | Field_set_twice { first; second } ->
      Diagnostic.error ~code:"E0213" ~at:second.span "field `%s` is set twice" second.text
      |> Diagnostic.label ~at:first.span "first set here"
  | Wrong_number_of_arguments { constructor; at; found } ->
      wrong_number_of_arguments constructor ~found at
  | Fields_missing { constructor; at; absent; last } -> fields_missing constructor ~absent ~last at
