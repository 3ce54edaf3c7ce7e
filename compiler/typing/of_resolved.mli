(** Translates Resolved to Typed: infers types and units, then checks levels and patterns. *)

open Basis

val program :
  ?sources:Source.t -> Fact.t Facts.t -> real:Real.t -> Resolve.Ir.program -> Ir.program option
(** [sources]: the files that messages quote from. [real]: the precision of [Float]. [None] after
    errors. *)

val partial : real:Real.t -> Resolve.Ir.program -> Ir.program
(** For editors: the definitions in a program with errors, as far as they could be typed. May raise
    {!Basis.Diagnostic.Bug}, because such a program does not satisfy the invariants of {!Ir}. *)
