(** Translates a node's step and reset: the effects of its items, as a {!Fragment}.

    Times and integrals advance first, then values are computed, and finally results and state are
    written. *)

val step :
  Calls.context ->
  State.t ->
  Flow.Ir.node ->
  limited:bool ->
  is_root:bool ->
  Statics.t ->
  Fragment.t * (Flow.Ir.atom -> Flow.Ir.atom)
(** Also returns a function that resolves copies. [limited] as in {!Memory.advance}. A node with one
    output returns it; the root always writes its outputs to a struct. *)

val reset : Calls.context -> State.t -> Flow.Ir.node -> Statics.t -> Fragment.t
(** Computes the static values, then everything that is initialized with them. *)
