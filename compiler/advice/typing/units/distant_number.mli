(** Numbers far from the place where their unit does not fit: in the definition of a function
    without a signature, or in the branches of a choice.

    [subject] and the pair of units are those of {!Number_mistake.units}. A result changes the
    message: it labels the numbers and suggests their units. *)

open Basis
open Typing

val chosen :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** The value is one of several numbers, such as [speed d] with
    [speed d = if d > 1[m] then 0.3 else 0.1]. *)

val scaled :
  Wording.t -> Resolve.Ir.expr -> Units.t * Units.t -> (Diagnostic.t -> Diagnostic.t) option
(** The value is a product of one number, which has its unit, and plain numbers: [0.4[m/s] * side].
*)

val compared :
  Wording.t -> expected:Expected.t -> Units.t * Units.t -> (Diagnostic.t -> Diagnostic.t) option
(** The function compares its parameter with a number, or adds them: [near d = d < 0.4]. *)
