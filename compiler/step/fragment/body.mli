(** A node's step and reset: what its items do, as a {!Fragment}.

    Times and integrals advance first, then values are computed, then results and state are written.
*)

val step :
  Calls.context ->
  State.t ->
  Flow.Ir.node ->
  limited:bool ->
  is_root:bool ->
  Statics.t ->
  Fragment.t * (Flow.Ir.atom -> Flow.Ir.atom)
(** Besides, how to look through copies. [limited] as in {!Memory.advance}. A node with one output
    returns it, but for the root, whose outputs are always written to a struct. *)

val reset : Calls.context -> State.t -> Flow.Ir.node -> Statics.t -> Fragment.t
(** The static values, then all that starts with them. *)
