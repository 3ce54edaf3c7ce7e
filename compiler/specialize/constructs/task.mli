(** Tasks, as values: what runs first, and what comes after it.

    A task is a [Primitive]: [mkTask] or [untilRight] of a signal function, [return] of a value, or
    [do] of a task and of the function that gives the task after it. So where a task stands in a
    program is itself a task: what is left of it. *)

open Basis

(** What runs first. *)
type head =
  | Runs of {
      signal_function : Value.t;
      primitive : Core.Primitive.t;  (** [Make_task] or [Until_right] *)
      output : Core.Ir.ty;  (** while it runs *)
      result : Core.Ir.ty;  (** what it ends with *)
    }
  | Ends of Value.argument  (** all of it has ended *)
  | Passes  (** to what comes next, at once: a mode of its own, as one cannot tell yet how often *)

val named : Context.t -> name:string option -> at:Span.t -> Value.t -> Value.t
(** A task that the prelude has made is named after the definition of the program that it is the
    value of, if any, and placed where the program uses the prelude's function. Any other value is
    as it was. *)

val name : Value.t -> string
(** Of what runs first in a reduced task. *)

val place : Value.t -> Span.t
(** Likewise. *)

val next : Value.t -> string * Span.t
(** Who says what runs next, and where. *)

val reduced : Evaluator.position -> Evaluator.t -> ?input:Value.argument -> Value.t -> Value.t
(** The same task, or choice of tasks, with a head: what ends at once is done with, in this node. On
    an [input] that is known that is also what is known to end at its first instant and keeps
    nothing, such as [snapT]: it is no mode, and takes no step. Reports tasks that end at once in a
    circle where nothing changes; then raises {!Context.Stopped}. *)

val head : Value.t -> head
(** Of a task that is reduced, and no choice. *)

val first : Value.t -> Value.t option
(** The signal function that runs first, if that is known of a task as it stands. *)

val after : Value.t -> Value.argument -> Value.t
(** What is left when the head of a reduced task has ended with this. *)
