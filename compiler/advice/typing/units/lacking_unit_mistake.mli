(** Messages about numbers and constants that lack their unit, as in [kp * err] with [kp = 0.8]. *)

open Typing

val needed : Units.t * Units.t -> int -> Units.t
(** The unit by which a factor with this exponent must be multiplied to correct the unit of the
    product. *)

val sides :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Resolve.Ir.expr * (Units.t * Units.t)) list
(** The expression, and the other operand of a sum or a comparison, each with its expected and its
    actual unit. If the context determines the unit of a sum, the list contains only the operand
    with the wrong unit. *)

val complete : Unit_rule.t
(** Points to the constants whose missing units may cause the mismatch, and suggests their units. *)

val is_unit_of_a_gain : Units.t -> bool
(** Does the unit have only negative exponents? *)

val of_a_literal : likely:bool -> Unit_rule.t
(** Like {!complete}, for a number literal that is a factor of the expression. If [likely],
    considers only literals with a decimal point, because such literals are rarely plain factors.
    Otherwise, considers only literals without a decimal point. *)

val of_the_only_decimal : Unit_rule.t
(** The only number with a decimal point in a product without a unit. *)

val gain_without_unit : Unit_rule.t
(** A sum of two products with gains, where only one of the gains has a unit. *)

val of_a_difference : Unit_rule.in_any_context
(** The difference between a signal and its previous value, where the signal's rate of change is
    expected. *)

val of_operands : Unit_rule.t
(** A sum of quantities that should be a product. *)

val of_fields : Unit_rule.t
(** A record whose numbers lack their unit, such as [Vec2 { x = 1, y = 2 }]. *)

val scaled : Wording.t -> Resolve.Ir.expr -> (Bare_number.t * int) list
(** The named constants without a unit that scale the expression, or an argument in it, as in
    [tag e (kp * err)]. *)

val of_an_argument : Unit_rule.in_any_context
(** An event or other container that holds a number without a unit, as in [tag e 0.5]. *)

val of_the_inverse : Unit_rule.in_any_context
(** A product that should be a quotient, or the reverse. *)
