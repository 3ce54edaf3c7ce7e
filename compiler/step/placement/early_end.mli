(** Ends the step of a mode early by checking the mode's transitions first.

    If a transition occurs, the outputs of the mode in that instant are discarded, and so is its
    state, because the next mode runs in the same instant. When a transition is known to occur, the
    rest of the step can be skipped, as in handwritten code:

    {v
    const bool arrived = frob_hypot(in->x - x, in->y - y) < 0.15;
    *out_arrived = arrived;
    if (!arrived) {
        ...
    }
    v} *)

val possible : Flow.Ir.program -> bool array
(** For each node, whether it is a mode that may end early: no transition of its machine is delayed,
    and the program has no components in C, which must run in every instant. *)

val needed : Fragment.t -> Fragment.ending -> bool array
(** The items that are needed if the mode ends. *)

val find :
  fresh:(unit -> int) ->
  resolve:(Flow.Ir.atom -> Flow.Ir.atom) ->
  Flow.Ir.node ->
  Fragment.t ->
  Fragment.t
(** Adds an [ending] to the step of a node. The node must be a mode that {!possible} allows.
    [resolve] resolves copies. *)
