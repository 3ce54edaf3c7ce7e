(** Warnings about angles that are not in radians: a number that looks like degrees ([W0303]), and
    an angle that was converted to degrees ([W0313]). *)

open Basis

val over_a_turn : Resolve.Ir.expr -> Diagnostic.t

val in_degrees :
  Wording.t ->
  angle:Resolve.Ir.expr ->
  factors:Resolve.Ir.expr list ->
  beside:Resolve.Ir.expr option ->
  Diagnostic.t
(** See {!Inference_fact.In_degrees}. *)
