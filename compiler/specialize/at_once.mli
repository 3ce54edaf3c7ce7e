(** Tasks that are known to end at their first instant, such as [snapT]: where one
    is started by another's end it is no mode, and takes no step. *)

open Basis

val event_type : Core.Ir.ty -> Core.Ir.ty
(** [Event] of it. *)

val either_type : Core.Ir.ty -> Core.Ir.ty -> Core.Ir.ty
(** [Either] of them. *)

val result :
  Context.t ->
  (span:Span.t -> result:Core.Ir.ty -> Value.t -> Value.argument -> Value.t) ->
  Node.t ->
  Value.argument option ->
  Task.head ->
  Value.argument option
(** What the task ends with at once, on this input, in this node, where the
    function runs signal functions. Only of one that keeps nothing. *)
