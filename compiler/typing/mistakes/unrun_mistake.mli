(** A signal function stands where the value of its signal is needed ([E0303]). *)

open Basis

val unrun :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  wanted:Type.t ->
  input:Type.t ->
  found:Type.t ->
  Diagnostic.t
(** The hint runs it, on a signal of the type [input] if there is one, and makes of its event the
    truth that is wanted. *)

(** {1 Arguments, in words} *)

val arguments_of : Resolve.Ir.expr -> Resolve.Ir.expr list
(** Of an application, in their order. *)

val count : int -> string
(** [two arguments] *)

val instead : Resolve.Ir.expr option -> string -> Diagnostic.t -> Diagnostic.t
(** With the fix that writes this text in the place of the expression. *)
