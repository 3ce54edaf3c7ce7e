open Basis
open Specialize

let label ~at format = Diagnostic.error ~code:"E0440" ~at format
let value ~at format = Diagnostic.error ~code:"E0441" ~at format

let diagnostic ({ at; problem } : Control_fact.t) =
  match problem with
  | Empty_label -> label ~at "a label cannot be empty"
  | Odd_character ->
      label ~at "a label cannot contain a comma, a quote, a backslash or a line break"
  | Space_at_an_end -> label ~at "a label cannot begin or end with a space"
  | Long_label { limit } -> label ~at "a label can have at most %d characters" limit
  | Unknown_label ->
      label ~at "this label is not known at compile time"
      |> Diagnostic.hint "give each button and knob a fixed label, and choose between their values"
  | Not_finite -> value ~at "the limits and the initial value of a knob must be finite numbers"
  | Limits { least; most } ->
      value ~at "the lower limit of this knob, %g, must be less than its upper limit, %g" least most
  | Initial { least; most; first } ->
      value ~at "the initial value of this knob, %g, is outside its limits, %g and %g" first least
        most
  | Unknown_knob ->
      value ~at "the limits and the initial value of this knob must be known at compile time"
      |> Diagnostic.note
           "you can use literals, constants, parameters with a constant value, and operators \
            applied to these"
      |> Diagnostic.hint "give the knob a fixed range, and scale its value"
  | Unknown_toggle -> value ~at "the initial position of this toggle must be known at compile time"
  | Taken { label = taken; kind; by } ->
      Diagnostic.(
        error ~code:"E0442" ~at "the console already has another control with the label `%s`" taken
        |> here "%s" (Core.Console.describe kind)
        |> label ~at:by.span "%s" (Core.Console.describe by.kind)
        |> hint "rename one of them")
