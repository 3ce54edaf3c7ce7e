open Basis
open Typing

let words environment = Wording.of_surroundings (Annotation.nowhere environment)

let scaled_power ~at (unit_ : Ir.Global.t) exponent =
  Diagnostic.error ~code:"E0322" ~at
    "`%s` is a scaled unit, so its exponent must be an integer, not %s" unit_.name
    (Rational.to_string exponent)
  |> Diagnostic.hint "write the number in base units"

let scaled_unit environment places measure =
  let text = Wording.measure (words environment) measure in
  let first = List.hd places and others = List.tl places in
  let d =
    Diagnostic.error ~code:"E0321" ~at:first
      "a type cannot contain a scaled unit, because values are stored in base units"
    |> Diagnostic.hint "%s; use scaled units only after literals"
         (if Units.equal measure Units.one then "write the type `Angle`, or the unit `1`"
          else Printf.sprintf "write `%s` here" text)
    |> Diagnostic.fix
         (Printf.sprintf "write `%s`" text)
         (List.map (fun place -> (place, text)) places)
  in
  List.fold_left (fun d at -> Diagnostic.label ~at "and here" d) d others

let array_size ~at size ~largest =
  Diagnostic.error ~code:"E0333" ~at "the size of an array must be from 1 to %d, not %d" largest
    size

let wrong_kind sources environment ~(at : Span.t) (wanted : Type.kind) found =
  let shown = Wording.quoted (words environment) found in
  let error format = Diagnostic.error ~code:"E0330" ~at format in
  match (wanted, Type.expand found) with
  | Of_types, Rigid _ ->
      error "%s is the size of an array elsewhere, so it cannot be a type here" shown
  | Of_sizes, Rigid _ ->
      error "%s is a type elsewhere, so it cannot be the size of an array here" shown
  | Of_types, _ -> error "expected a type, found the size %s" shown
  | Of_sizes, _ ->
      error "expected the size of an array, found the type %s" shown
      |> Diagnostic.hint "%s"
           (match
              Option.bind (Source.text sources at.file) (fun text ->
                  Other_type.changed text (Text_place.offset text at.start))
            with
           | Some signature -> "write the size first: " ^ signature
           | None -> "write the size first, as in `Array 4 Float`")
