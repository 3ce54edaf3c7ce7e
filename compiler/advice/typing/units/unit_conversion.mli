(** Suggestions for converting one quantity to another, such as a gain, a root or a unit. *)

open Basis
open Typing

val is_per_second : Show.words -> Units.t -> bool
val is_operand : Expected.t -> bool

val suggest :
  Show.words ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  Diagnostic.t ->
  Diagnostic.t
(** Adds the hint that is most likely to help. The pair contains the expected unit and the actual
    one. *)
