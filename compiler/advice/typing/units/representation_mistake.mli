(** Messages about an Int where a Float is expected, or the reverse ([E0312]).

    The last argument is the mismatched pair: the expected and the given representation. [subject]:
    the expression that has the wrong type, if there is one. *)

open Basis
open Typing

val representations :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Type.representation * Type.representation ->
  Diagnostic.t
(** The message about an Int in place of a Float, or the reverse. Pass the result of
    {!without_open_units} as [expected]. *)

val without_open_units : Expected.t -> Expected.t
(** Replaces undetermined units with 1. In a mismatch between Int and Float they are irrelevant. *)

val makes : string -> string -> string option
(** For a few types, a sentence that explains how to build a value of the named type from a number.
    The second string is the source text of the number. *)
