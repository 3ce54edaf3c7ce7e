(** Messages about mismatched units ([E0320]).

    The last argument is the mismatched pair: the expected and the given unit. [subject]: the
    expression that has the wrong type, if there is one. *)

open Basis
open Typing

type Diagnostic.topic +=
  | Corrected_signature  (** the hint that suggests another signature, for a result of this type *)

val units :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Units.t * Units.t ->
  Diagnostic.t
(** The message about mismatched units, in numbers or in types that contain numbers. *)
