(** Causality: no signal may need its own value within one instant.

    Reads a linted flow program and leaves it unchanged. [Delay] and [Integral] break a dependency;
    an [Instance] only passes on the inputs that its node reads in the same instant (see
    {!Dependency}). Method: computes the strongly connected components of each node's same-instant
    dependency graph. Each cyclic component results in one fact, with the shortest loop. *)

open Basis

val check : Fact.t Facts.t -> entry:Span.t -> Ir.program -> unit
(** Reports each loop. [entry] is the place of the program's definition. *)

val is_causal : Ir.program -> bool
(** Whether {!check} has nothing to report. *)
