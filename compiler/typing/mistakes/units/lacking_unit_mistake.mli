(** A constant without a unit that is a factor of a quantity, as in [kp * err] with [kp = 0.8]. *)

open Basis

val complete :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** Points to the constants that would correct the expression's unit, and suggests their units. The
    units are the one that was expected and the one that was found. *)
