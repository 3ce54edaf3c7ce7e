(** What is said about numbers that do not fit: their units differ ([E0320]), or one is an Int and
    the other a Float ([E0312]).

    In both, the last argument is the pair that clashes: wanted, then given. [subject] is the
    expression at fault, if it is one. *)

open Basis

val units :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Units.t * Units.t ->
  Diagnostic.t
(** Of a number, or of types that have numbers in them. *)

val representations :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Type.representation * Type.representation ->
  Diagnostic.t
(** As {!units}; [expected] is {!without_open_units}. *)

val without_open_units : Expected.t -> Expected.t
(** Between Int and Float a unit that is still to be found is no matter. *)

val makes : string -> string -> string option
(** What makes one of this type of a number, of types of which that is easily told. *)
