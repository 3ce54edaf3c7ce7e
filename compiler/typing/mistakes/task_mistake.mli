(** What is said where one of two types is that of a task: it stands where a signal function
    belongs, or the reverse ([E0371]), a statement of a [do] is no task ([E0370]), or two tasks
    differ in one thing ([E0301]).

    [subject] is the expression at fault, if it is one. *)

open Basis

val task_and_signal_function :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Diagnostic.t
(** [found] is the one of the two that stands in the place of the other. *)

val no_task :
  Show.words -> subject:Resolve.Ir.expr option -> at:Span.t -> found:Type.t -> Diagnostic.t

val unlike_tasks :
  Show.words ->
  at:Span.t ->
  because:Expected.reason ->
  Type.t * Type.t * Type.t ->
  Type.t * Type.t * Type.t ->
  Diagnostic.t option
(** What is expected, then what is found, both as {!Environment.as_task} gives it; [None] if they
    differ in more than one of the three. *)

val beside_each_other : Expected.t -> string option
(** The cure of tasks between operators of truths. *)
