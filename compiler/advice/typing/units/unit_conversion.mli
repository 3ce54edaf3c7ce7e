(** Suggestions that convert one quantity to another, for example with a gain, a root or a unit. *)

open Basis
open Typing

val is_per_second : Wording.t -> Units.t -> bool
val is_operand : Expected.t -> bool

val is_of_a_signal : Wording.t -> Expected.t -> bool
(** Is the expected type the type of a signal: the output of a signal function, or a local signal of
    a proc? *)

val of_the_other_operand :
  Wording.t -> expected:Expected.t -> Units.t * Units.t -> Unit_rule.complete option
(** For [way < 2[m]], where [way] is a velocity: suggests the integral of [way], or the derivative
    in the opposite case. *)

val suggest :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  Diagnostic.t ->
  Diagnostic.t
(** Adds the hint that is most likely to help. The pair contains the expected unit and the actual
    one. *)
