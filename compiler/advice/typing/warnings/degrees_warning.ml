open Basis

let over_a_turn (e : Resolve.Ir.expr) =
  let write (number : Resolve.Ir.expr) digits text d =
    Diagnostic.hint text digits d |> Diagnostic.write number.span (digits ^ "[deg]")
  in
  Diagnostic.warning ~code:"W0303" ~at:e.span
    "this angle is in radians, so it is more than a whole turn"
  |>
  match e.desc with
  | Number n -> write e n.digits "if you meant degrees, write `%s[deg]`"
  | Negate ({ desc = Number n; _ } as number) ->
      write number n.digits "if you meant degrees, write `(-%s[deg])`"
  | _ -> Diagnostic.hint "if you meant degrees, give one of the numbers its unit, as in `90[deg]`"

let in_degrees words ~(angle : Resolve.Ir.expr) ~factors ~beside =
  let quote (e : Resolve.Ir.expr) = Wording.quote words e.span in
  let itself =
    match factors with
    | [ factor ] -> Option.fold (quote factor) ~none:"" ~some:(Printf.sprintf ": write `%s`")
    | _ -> ""
  in
  let other =
    match Option.map (fun (b : Resolve.Ir.expr) -> (b.span, quote b)) beside with
    | Some (at, Some text) -> Diagnostic.label ~at "`%s` is in radians" text
    | Some (at, None) -> Diagnostic.label ~at "this is in radians"
    | None -> Fun.id
  in
  Diagnostic.warning ~code:"W0313" ~at:angle.span "this is in degrees, but angles are in radians"
  |> other
  |> Diagnostic.hint "remove the conversion, because `90[deg]` is in radians too%s" itself
