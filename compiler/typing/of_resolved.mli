(** From Resolved to Typed: types and units, then levels and patterns. *)

open Basis

val program :
  ?sources:Source.t -> Diagnostic.sink -> real:Real.t -> Resolve.Ir.program -> Ir.program option
(** [sources]: what messages quote from. [real]: the precision of [Float]. [None] after
    errors. *)
