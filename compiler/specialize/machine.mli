(** Switches: several signal functions, of which one runs at a time.

    Running a [switch] makes a node with a {!Flow.Ir.machine}. Its first mode
    runs the switch's signal function, and has a transition for each signal
    function that the continuation can give of the event's value. One that is
    itself a switch is a mode of the same machine, any other a mode without
    transitions. A mode is found by its {!Skeleton}, so a definition that
    comes back to itself through continuations closes a circle; what the
    skeleton leaves out, first-order values, are the mode's parameters. *)

open Basis

(** Evaluation in a node under construction. *)
type evaluator = {
  run :
    Context.t ->
    Context.trail ->
    Node.t ->
    span:Span.t ->
    result:Core.Ir.ty ->
    Value.t ->
    Value.argument ->
    Value.t;
      (** A signal function's output; a proc's equations stand in the node
          itself. *)
  apply :
    Context.t ->
    Context.trail ->
    Node.t ->
    span:Span.t ->
    result:Core.Ir.ty ->
    Value.t ->
    Value.argument ->
    Value.t;
  static : Context.t -> Context.trail -> Node.t -> Value.closure -> Core.Ir.expr -> Value.t;
      (** an expression in a proc that mentions no signal of it *)
}

val run :
  Context.t ->
  evaluator ->
  Context.trail ->
  Node.t ->
  Node.target ->
  span:Span.t ->
  result:Core.Ir.ty ->
  Value.t ->
  Value.argument ->
  Value.t
(** An instance of a switch, of a signal function chosen when it starts, or of
    [runTask t], whose [result] is here of three parts: the task's output, whether
    it has ended, and what it ended with.
    May raise {!Context.Stopped} and {!Context.Postponed}. *)
