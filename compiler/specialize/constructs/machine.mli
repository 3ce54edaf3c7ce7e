(** Switches run several signal functions, one at a time.

    Running a [switch] creates a node with a {!Flow.Ir.machine}. The machine's first mode runs the
    switch's signal function. This mode has a transition for each signal function that the
    continuation can return for the event's value. If the returned signal function is itself a
    switch, it becomes a mode of the same machine with transitions of its own; otherwise it becomes
    a mode without transitions.

    A mode is identified by its {!Specialization_key}. A definition that returns to itself through
    continuations therefore forms a cycle of modes. The first-order values, which are not part of
    the key, are the parameters of the mode. *)

val run :
  Evaluator.position ->
  Evaluator.t ->
  Node.target ->
  result:Core.Ir.ty ->
  Value.t ->
  Value.argument ->
  Value.t
(** Runs an instance of a switch, a signal function that is chosen at the start, or [runTask t]. For
    [runTask t], the [result] has three parts: the output of the task, whether it has ended, and its
    result. May raise {!Context.Stopped} and {!Context.Postponed}. *)
