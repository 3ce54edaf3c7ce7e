(** Causality: no signal may need its own value within one instant.

    Reads a linted flow program and leaves it unchanged. [Delay] and [Integral] break a dependency;
    an output of an [Instance] depends only on the inputs from which its node computes it in the
    same instant (see {!Dependency}). Method: computes the strongly connected components of each
    node's same-instant dependency graph, and reports one fact for each cyclic component, with its
    shortest loop. *)

open Basis

val check : Fact.t Facts.t -> entry:Span.t -> Ir.program -> unit
(** Reports each loop. [entry] is the place of the program's definition. *)

val is_causal : Ir.program -> bool
(** Whether the program has no loops, so that {!check} reports nothing. *)
