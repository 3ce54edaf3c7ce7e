open Basis
open Specialize

let component ~at symbol =
  Diagnostic.(
    error ~code:"E0431" ~at "the program and the C component `%s` have the same name" symbol
    |> note "both would define `struct %s_state`, `%s_reset` and `%s_step`" symbol symbol symbol
    |> hint "rename the program's file")

let function_ ~at symbol =
  Diagnostic.(
    error ~code:"E0431" ~at "the generated C code already has a function `%s`" symbol
    |> note "frobc names the functions of a program after its file"
    |> hint "rename the program's file")

let name (fact : Fact.foreign_name) =
  match fact with
  | Function_or_component { kind = Stateful; span = at; symbol; _ } -> component ~at symbol
  | Function_or_component { kind = Stateless _; span = at; symbol; _ } -> function_ ~at symbol
  | Header h ->
      Diagnostic.(
        error ~code:"E0431" ~at:(Span.start_of_file h.of_file)
          "the program includes `%s`, but the header that frobc generates has the same name"
          h.header
        |> hint "rename the program's file or the header")

let of_the_instant ~at (ty : Flow.Ir.foreign_type) =
  if Flow.Shape.is_image ty then
    Diagnostic.(
      error ~code:"E0430" ~at "an image cannot be kept from one instant to the next"
      |> note "the camera reuses the memory of an image for later frames"
      |> hint "when the frame arrives, compute the numbers that you need, and `hold` them")
  else
    Diagnostic.(
      error ~code:"E0430" ~at
        "a value of the foreign type `%s` cannot be kept from one instant to the next"
        ty.foreign_name
      |> note "a `%s` from C is valid for one instant; the C code may reuse its memory after that"
           ty.foreign_name
      |> hint
           "keep only the numbers that you need, or declare the type `copyable` if a copy of the \
            struct works like the original")
