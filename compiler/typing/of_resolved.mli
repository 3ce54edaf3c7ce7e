(** From Resolved to Typed: types and units, then levels and patterns. *)

open Basis

val program :
  ?sources:Source.t -> Diagnostic.sink -> real:Real.t -> Resolve.Ir.program -> Ir.program option
(** [sources]: what messages quote from. [real]: the precision of [Float]. [None] after errors. *)

val partial : real:Real.t -> Resolve.Ir.program -> Ir.program
(** Of a program with errors the definitions that have types all the same, for editors. May raise
    {!Basis.Diagnostic.Bug}, as nothing is promised of such a program. *)
