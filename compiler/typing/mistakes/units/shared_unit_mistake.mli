(** A number whose unit differs from that of the other arguments of a function with one unit
    variable, as in [min 0.3 v] for a velocity [v]. *)

open Basis

val of_an_earlier_number :
  Show.words ->
  expected:Expected.t ->
  found:Type.t ->
  subject:Resolve.Ir.expr option ->
  Units.t * Units.t ->
  Diagnostic.t option
(** The mismatch is reported at an argument, but an earlier argument that is a number literal
    determined the unit: reports that number, with the unit that it should have. The units are the
    one that was expected and the one that was found. *)
