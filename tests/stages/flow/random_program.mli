(** Random well-typed Flow programs: several nodes that instantiate each other, every kind of
    equation, feedback through delays, integrals and instances. Most, not all, are causal. *)

val maybe : Flow.Ir.sum
(** [Maybe Float], the only sum in them. *)

val program : Random.State.t -> Flow.Ir.program
val instants : Random.State.t -> Flow.Ir.program -> Evaluate.instant list
