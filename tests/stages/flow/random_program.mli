(** Random well-typed Flow programs: several nodes that instantiate each other, every kind of
    equation, and feedback through delays, integrals and instances. Most of them are causal, but not
    all. *)

val maybe : Flow.Ir.sum
(** [Maybe Float], the only sum type in them. *)

val program : Random.State.t -> Flow.Ir.program
val instants : Random.State.t -> Flow.Ir.program -> Evaluate.instant list
