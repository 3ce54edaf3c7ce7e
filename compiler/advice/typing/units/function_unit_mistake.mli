(** Messages about units that do not fit one particular function, such as a frequency as the
    argument of [sin]. *)

open Basis
open Typing

val complete :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** Adds the hint for the function that takes this argument, if there is one for that function. The
    pair contains the expected unit and the actual one. *)

val power :
  Wording.t -> expected:Expected.t -> ?unit_:string -> unit -> (Diagnostic.t -> Diagnostic.t) option
(** [d ** 2] for a base [d] that `**` does not accept, because it has a unit or is an `Int`. *)

val whole_numbers :
  Wording.t -> expected:Expected.t -> found:Type.t -> (Diagnostic.t -> Diagnostic.t) option
(** Numbers with a fractional part as arguments of [mod] or [div]. *)

val quotient : Wording.t -> expected:Expected.t -> (Diagnostic.t -> Diagnostic.t) option
(** Whole numbers as operands of [/]. *)
