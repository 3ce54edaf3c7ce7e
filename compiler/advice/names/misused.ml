open Basis
open Syntax.Ir

let size (size : Resolve.Fact.size) (name : name) =
  let d = Diagnostic.error ~code:"E0205" ~at:name.span "unknown name `%s`" name.text in
  match size.array with
  | Some array ->
      let text = "length " ^ array in
      Diagnostic.hint "`%s` is a size in the type of `%s`: to use it as a number, write `%s`"
        name.text size.of_ text d
      |> Diagnostic.write name.span (Source.grouped text)
  | None ->
      Diagnostic.hint
        "`%s` is a size in the type of `%s`: to use it as a number, write `length xs`, where `xs` \
         is an array of this size"
        name.text size.of_ d

(* The unit as it would be written in brackets. *)
let rec measure (e : expr) =
  match e.desc with
  | Variable { name; _ } | Constructor { name; _ } -> name.text
  | Number { digits; _ } -> digits
  | Binary { operator; left; right } -> measure left ^ operator.name.text ^ measure right
  | Power { base; exponent } -> Printf.sprintf "%s^%d" (measure base) exponent
  | Parenthesized inner -> "(" ^ measure inner ^ ")"
  | _ -> "…"

(* `(k * x)[m/s]` *)
let unit_of_a_value ~(head : expr) ~unit_ ~(at : Span.t) =
  let unit_ = measure unit_ in
  Diagnostic.error ~code:"E0205" ~at
    "a unit can only follow a literal number or a type, not a computed value"
  |> Diagnostic.hint
       "a value already has its unit; to give a plain number a unit, multiply: `x * 1[%s]`" unit_
  |>
  match head.desc with
  | Parenthesized _ ->
      let at = Span.make ~file:at.file ~start:head.span.stop ~stop:at.stop in
      Diagnostic.fix "multiply by the unit" [ (at, Printf.sprintf " * 1[%s]" unit_) ]
  | _ -> Fun.id

(* `3 [m/s]` *)
let unit_apart ~(head : expr) ~unit_ ~at =
  let number = match head.desc with Apply (_, argument) -> argument | _ -> head in
  let with_unit digits = Printf.sprintf "%s[%s]" digits (measure unit_) in
  let digits = match number.desc with Number { digits; _ } -> Some digits | _ -> None in
  Diagnostic.error ~code:"E0205" ~at "there is a space between this unit and its number"
  |> Diagnostic.hint "write the unit in square brackets directly after the number: `%s`"
       (with_unit (Option.value digits ~default:"3"))
  |>
  match digits with
  | Some digits -> Diagnostic.write (Span.merge number.span at) (with_unit digits)
  | None -> Fun.id

(* `x p` for `p.x` *)
let field ~whole ~(field : name) ~(record : name) =
  let text = Printf.sprintf "%s.%s" record.text field.text in
  Diagnostic.error ~code:"E0205" ~at:field.span "`%s` is a field, not a function" field.text
  |> Diagnostic.hint "write `%s`, or `\\r -> r.%s` if you need a function" text field.text
  |> Diagnostic.fix (Printf.sprintf "write `%s`" text) [ (whole, "(" ^ text ^ ")") ]
