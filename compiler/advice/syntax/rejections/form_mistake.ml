open Basis
open Syntax

let error at format = Diagnostic.error ~code:"E0110" ~at format

let context at =
  error at "expected classes before `=>`, each with one type"
  |> Diagnostic.hint "write, for example, `(Eq a, Ord b) => …`"

let class_head at =
  error at "a class head must be the name of the class and one type variable"
  |> Diagnostic.hint "write, for example, `class Shape a where`"

let superclass ~at ~(class_ : Ir.name) (variable : Ir.name) =
  error at "a superclass must use the class's own variable `%s`" variable.text
  |> Diagnostic.hint "write, for example, `class Eq %s => %s %s`" variable.text class_.text
       variable.text

let instance_head at =
  error at "an instance head must be a class and one type"
  |> Diagnostic.hint
       "write, for example, `instance Shape Circle where` or `instance Shape (Maybe a) where`"

let foreign_word ~expected (found : Ir.name) =
  error found.span "expected `%s` here, found `%s`" expected found.text
  |> Diagnostic.hint
       "write, for example, `foreign name :: Float -> Float = \"c_name\"`, `foreign sf name :: SF \
        Float Float = \"c_name\"`, `foreign type Name = \"struct name\"` or `foreign include \
        \"name.h\"`"

let size ~at digits = error at "the size of an array must be a whole number, not `%s`" digits

(* The Frob equivalent of the signature that contains this `<` or, if there is none, of the C++ type
   alone. *)
let type_in_angles ~text (at : Span.t) =
  let sign = Text_place.offset text at.start in
  let rec start i = if i > 0 && Character.is_name text.[i - 1] then start (i - 1) else i in
  if sign > String.length text then None
  else
    match Other_type.of_signature text sign with
    | Some signature -> Some signature
    | None -> Option.map (fun (t, _) -> "`" ^ t ^ "`") (Other_type.in_angles text (start sign))

let size_operator ~text ~at operator =
  if not (String.equal operator "<") then
    error at "a size can contain the operators `+`, `-` and `*`, but not `%s`" operator
  else
    match type_in_angles ~text at with
    | Some written ->
        error at "type arguments are separated by spaces, not enclosed in `<>`"
        |> Diagnostic.hint "write %s" written
    | None ->
        error at
          "type arguments are separated by spaces, as in `Event Distance`, not enclosed in `<>`"

let empty_where at =
  error at "this `where` has no definitions"
  |> Diagnostic.hint
       "indent the definitions after `where` further than the definition that the `where` belongs \
        to"

(* {1 Units} *)

let error at format = Diagnostic.error ~code:"E0119" ~at format

let number_in_unit ~text ~(at : Span.t) digits =
  match Other_type.signature text (Text_place.offset text at.start) with
  | Some signature when Other_type.mentions ("Array " ^ digits) signature ->
      error at "the brackets after a type contain a unit, not the size of an array"
      |> Diagnostic.hint "write `%s`" signature
  | Some _ | None ->
      error at "the number `%s` cannot be part of a unit: the only number allowed there is `1`"
        digits
      |> Diagnostic.hint
           "write a power as `m^2`; an array of %s elements has the type `Array %s Float`" digits
           digits

let exponent_not_whole ~at digits =
  error at "the exponent `%s` of a unit is not a whole number" digits
  |> Diagnostic.hint "write a root as `m^(1/2)`"

let exponent_too_large at =
  error at
    "the exponent of a unit must be a whole number up to 1000, or a quotient of two such numbers"

let exponent_over_zero at = error at "the exponent of this unit divides by zero"

let scale at =
  error at
    "the scale of a unit must be a number, `pi` or their product, optionally divided by a number"
  |> Diagnostic.hint "write, for example, `unit inch = 0.0254 m` or `unit deg = pi/180`"
