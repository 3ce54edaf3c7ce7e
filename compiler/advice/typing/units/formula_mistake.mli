(** Messages about formulas whose unit shows that an operation is missing, such as a square root or
    a sum over time. *)

open Typing

val root : Unit_rule.t
(** A square, or a sum of squares, whose square root is needed: [dx * dx + dy * dy > 0.5[m]]. *)

val is_of_square : Wording.t -> subject:Resolve.Ir.expr option -> Units.t * Units.t -> bool
(** Is the expression a square or a sum of squares, and does its root have the expected unit? *)

val power : Unit_rule.t
(** A product whose missing factor has the unit of one of its variables: [v / (2 * a)] for
    [v ^ 2 / (2 * a)]. *)

val rate : Unit_rule.t
(** The sum of a quantity and its rate of change: [heading + turnRate i]. *)

val of_fields : Unit_rule.in_any_context
(** A record with a field that contains the square of the intended value. *)

val within_root : Unit_rule.in_any_context
(** A square root of a quantity that lacks a factor: [sqrt (2 * d)], which is not a velocity. *)

val upside_down : Unit_rule.in_any_context
(** [a / b] where the unit of [b / a] is expected. *)

val rounded : Unit_rule.in_any_context
(** A rounded quantity where a plain number is expected: [round (d * 100)]. *)

val gain_of_rate : Unit_rule.t
(** A sum with [kd * derivative e], where the unit of the parameter [kd] is wrong. *)

val rate_for_angle : Unit_rule.in_any_context
(** A literal in radians per second or degrees per second where an angle is expected. *)
