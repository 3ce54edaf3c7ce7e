(** The first instant, whose dt is to be 0 wherever it shows. *)

val shows_in : State.t -> Statics.t -> bool
(** Whether the dt of the first instant shows in what a node computes, but for
    the nodes that it steps: an integral of what was before multiplies it by 0,
    but a derivative and a time do not. *)

val mark : State.t -> Statics.t -> Basis.Span.t -> Ir.mark * Ir.statement list
(** What tells the root's first step, and what the reset does for it: a delay that the
    program has anyway, or else a field of its own. *)
