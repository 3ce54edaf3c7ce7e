(** How the root's step knows its first instant, whose dt is to be 0 wherever it
    shows.

    The number of the running mode may tell, if the step enters the first one;
    so may a delay that the program has anyway, perhaps with a branch for the first instant
    (see {!First_apart}); else a field of its own does. Where only one derivative sees the
    first dt, it asks for itself, and dt needs no choice. *)

val shows_in : State.t -> Statics.t -> bool
(** Whether the dt of the first instant shows in what a node computes, but for
    the nodes that it steps: an integral of what was before multiplies it by 0,
    but a derivative and a time do not. *)

type t = {
  step : Ir.statement list;
  reset : Ir.statement list;
  told : Ir.first_instant;
}

val tell :
  Calls.context ->
  State.t ->
  Flow.Ir.node ->
  Statics.t ->
  callees_see:bool ->
  step:Ir.statement list ->
  reset:Ir.statement list ->
  t
(** The bodies of the root, changed so that the first instant is told from
    others. May add a field to the state. [callees_see]: the dt of the first instant shows
    in a node that this one steps then. *)
