(** A number whose unit differs from the unit of the other arguments of a function with one unit
    variable, as in [min 0.3 v] for a velocity [v]. *)

open Basis
open Typing

val of_an_earlier_number :
  Wording.t ->
  expected:Expected.t ->
  found:Type.t ->
  subject:Resolve.Ir.expr option ->
  Units.t * Units.t ->
  Diagnostic.t option
(** Handles a mismatch at an argument whose expected unit comes from a number literal among the
    earlier arguments. The message reports that literal and the unit that it should have. The pair
    contains the expected unit and the actual one. *)
