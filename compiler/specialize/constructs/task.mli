(** Tasks as values: their first step, and the task that follows it.

    A task is a [Primitive]: [mkTask] or [untilRight] of a signal function, [return] of a value, or
    [do] of a task and the function that returns the next task. The state of a running task is
    therefore itself a task: the part that has not run yet. *)

open Basis

(** The first step of a task. *)
type head =
  | Runs of {
      signal_function : Value.t;
      primitive : Core.Primitive.t;  (** [Make_task] or [Until_right] *)
      output : Core.Ir.ty;  (** the type of its output while it runs *)
      result : Core.Ir.ty;  (** the type of its result *)
    }
  | Ends of Value.argument  (** the whole task has ended with this result *)
  | Passes
      (** the first part has ended, and the task continues immediately. This step becomes a separate
          mode, because the number of such steps is not yet known *)

val named : Context.t -> name:string option -> at:Span.t -> Value.t -> Value.t
(** If one of the program's definitions consists of a task that the prelude creates, names the task
    after that definition. The task's place becomes the place where the program uses the prelude's
    function. Other values are returned unchanged. *)

val name : Value.t -> string
(** The name of the task that runs first in a reduced task. *)

val place : Value.t -> Span.t
(** The place of the task that runs first in a reduced task. *)

val next : Value.t -> string * Span.t
(** The definition that determines what runs next: its name and place. *)

val reduced : Evaluator.position -> Evaluator.t -> ?input:Value.argument -> Value.t -> Value.t
(** An equivalent task, or choice of tasks, that has a head: the parts that end immediately are
    evaluated in this node. If [input] is given, these include stateless tasks that are known to end
    in their first instant, such as [snapT]; they neither become modes nor take a step. If tasks
    form a cycle in which each ends immediately and nothing changes, reports the cycle and raises
    {!Context.Stopped}. *)

val head : Value.t -> head
(** The head of a reduced task that is not a choice between tasks. *)

val first : Value.t -> Value.t option
(** The signal function that runs first, if it is known without reducing the task. *)

val after : Value.t -> Value.argument -> Value.t
(** The task that remains when the head of a reduced task has ended with this result. *)
