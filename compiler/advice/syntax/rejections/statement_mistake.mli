(** Messages about statements that a [do] cannot contain. *)

open Basis

val in_proc : is_last:bool -> Syntax.Ir.expr -> Diagnostic.t
(** An expression used as a statement of a [proc]. *)

val output_binds : at:Span.t -> string option -> Diagnostic.t
val output_is_let : at:Span.t -> string option -> Diagnostic.t
val empty_proc : Span.t -> Diagnostic.t
val last_task_binds : at:Span.t -> string option -> Diagnostic.t
val last_task_is_let : Span.t -> Diagnostic.t
val empty_task : Span.t -> Diagnostic.t
val rec_in_task : Span.t -> Diagnostic.t
