(** What is said about types of another shape: a function where a number belongs, a signal function
    where its signal's value is wanted.

    Codes: [E0301] different types · [E0303] a signal function where its signal's value is wanted,
    by {!Unrun_mistake} · [E0304] a function where a signal function is wanted, or the reverse ·
    those of {!Task_mistake}. *)

open Basis

val shapes :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Diagnostic.t
(** [subject] is the expression at fault, if it is one. *)
