(** Switches: several signal functions, of which one runs at a time.

    Running a [switch] makes a node with a {!Flow.Ir.machine}. Its first mode runs the switch's
    signal function, and has a transition for each signal function that the continuation can give of
    the event's value. One that is itself a switch is a mode of the same machine, any other a mode
    without transitions. A mode is found by its {!Skeleton}, so a definition that comes back to
    itself through continuations closes a circle; what the skeleton leaves out, first-order values,
    are the mode's parameters. *)

val run :
  Evaluator.position ->
  Evaluator.t ->
  Node.target ->
  result:Core.Ir.ty ->
  Value.t ->
  Value.argument ->
  Value.t
(** An instance of a switch, of a signal function chosen when it starts, or of [runTask t], whose
    [result] is here of three parts: the task's output, whether it has ended, and what it ended
    with. May raise {!Context.Stopped} and {!Context.Postponed}. *)
