(** Warnings about the statements of a task: a [return] before the last statement ([W0312]), and a
    statement after a task that never ends ([W0318]). *)

open Basis

val idle_return :
  Wording.t -> Resolve.Ir.expr -> is_choice:bool -> next:Span.t option -> Diagnostic.t
(** See {!Typing.Inference_fact.Idle_return}. *)

val unreachable : at:Span.t -> Resolve.Ir.expr -> Diagnostic.t
(** [at] is the unreachable statement; the expression is the head of the endless task before it. *)
