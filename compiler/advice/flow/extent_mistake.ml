open Basis
open Flow

let shown = 5

let diagnostic ~entry (measure : Fact.measure) ~amount ~limit largest =
  let label (d, places) ({ whole; part; count; at } : Fact.part) =
    if List.length places >= shown || List.mem at places then (d, places)
    else
      let what =
        if count > 1. then Printf.sprintf "%.0f of `%s`" count part else Printf.sprintf "`%s`" part
      in
      (Diagnostic.label ~at "`%s` contains %s" whole what d, at :: places)
  in
  let error =
    match measure with
    | Values ->
        Diagnostic.error ~code:"E0413" ~at:entry
          "the program would store %.3g values from one instant to the next; the maximum is %.0f"
          amount limit
    | Instances ->
        Diagnostic.error ~code:"E0413" ~at:entry
          "the program would run %.3g signal functions at the same time; the maximum is %.0f" amount
          limit
  in
  fst (List.fold_left label (error, []) largest)
  |> Diagnostic.note
       "each use of a signal function has its own copy of the state, including the state of all \
        signal functions inside it"
  |> Diagnostic.hint
       "to run a signal function only once, name its output in an equation, and use that name \
        wherever you need the output"
