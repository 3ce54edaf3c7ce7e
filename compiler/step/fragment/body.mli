(** Translates a node's step and reset: converts the effects of the node's items to a {!Fragment}.
    The step first advances times and integrals, then computes values, and finally writes results
    and state. *)

val step :
  Calls.context ->
  State.t ->
  Flow.Ir.node ->
  limited:bool ->
  is_root:bool ->
  Statics.t ->
  Fragment.t * (Flow.Ir.atom -> Flow.Ir.atom)
(** Also returns a function that resolves copies. For [limited], see {!Memory.advance}. The step of
    a node with one output returns that output; the root always writes its outputs to a struct. *)

val reset : Calls.context -> State.t -> Flow.Ir.node -> Statics.t -> Fragment.t
(** Computes the static values, and then initializes the state. *)
