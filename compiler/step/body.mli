(** The statements of a node's step and reset: what its items do, described as a
    {!Fragment} and placed.

    Times and integrals advance first, then values are computed, then results
    and state are written. *)

val step :
  Calls.context ->
  State.t ->
  Flow.Ir.node ->
  limited:(Flow.Ir.atom -> bool) ->
  is_root:bool ->
  may_end_early:bool ->
  Statics.t ->
  Ir.statement list * (int * int) option
(** The statements, and the node's [ends_early]. [limited] as in {!Memory.advance}. A node with one output returns it, but for the root, whose outputs are
    always written to a struct. *)

val reset : Calls.context -> State.t -> Flow.Ir.node -> Statics.t -> Ir.statement list
(** The static values, then all that starts with them. *)
