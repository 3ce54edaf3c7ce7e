(** Messages about types of different shapes, for example a function where a number is expected.

    Codes: [E0301] different types · [E0303] a signal function where its output is expected
    ({!Unrun_mistake}) · [E0304] a function where a signal function is expected, or the reverse ·
    the codes of {!Task_mistake}. *)

open Basis
open Typing

val shapes :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Diagnostic.t
(** [subject]: the expression that has the wrong type, if there is one. *)
