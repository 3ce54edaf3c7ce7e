(** Causality: no signal may need its own value within one instant.

    Reads a linted flow program and leaves it unchanged. [Delay] and [Integral] break a dependency;
    an [Instance] only passes on the inputs that its node reads in the same instant (see
    {!Dependency}). Method: computes the strongly connected components of each node's same-instant
    dependency graph. Each cyclic component results in one diagnostic, which shows the shortest
    loop. *)

val check :
  Basis.Diagnostic.sink -> sources:Basis.Source.t -> entry:Basis.Span.t -> Ir.program -> unit
(** Reports [E0401] for each loop. The hints quote [sources]. [entry] is the place of the program's
    definition: for a loop inside the library, the message shows the place in the program that uses
    it. *)
