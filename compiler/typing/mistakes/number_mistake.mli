(** Messages about mismatched numbers: the units differ ([E0320]), or one is an Int and the other a
    Float ([E0312]).

    For both, the last argument is the clashing pair: the wanted and the given type. [subject]: the
    expression that has the wrong type, if there is one. *)

open Basis

val units :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Units.t * Units.t ->
  Diagnostic.t
(** The message about mismatched units, in numbers or in types that contain numbers. *)

val representations :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Type.representation * Type.representation ->
  Diagnostic.t
(** The message about an Int and a Float; pass {!without_open_units} as [expected]. *)

val without_open_units : Expected.t -> Expected.t
(** Replaces undetermined units by 1. In a mismatch between Int and Float they are irrelevant. *)

val makes : string -> string -> string option
(** A sentence that explains how to build a value of the type with this name from a number, for a
    few types. The second string is the number's source text. *)
