(** Messages about formulas whose unit shows that an operation is missing, such as a square root or
    a sum over time. Each pair of units contains the expected unit and the actual one. *)

open Basis
open Typing

val root :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A square, or a sum of squares, whose square root is needed: [dx * dx + dy * dy > 0.5[m]]. *)

val is_of_square : Wording.t -> subject:Resolve.Ir.expr option -> Units.t * Units.t -> bool
(** Is the expression a square or a sum of squares, and does its root have the expected unit? *)

val power :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A product that lacks a factor with the unit of one of its variables: [v / (2 * a)] for
    [v ^ 2 / (2 * a)]. *)

val rate :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** The sum of a quantity and its rate of change: [heading + turnRate i]. *)

val of_fields :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A record with a field that contains the square of the intended value. *)

val within_root :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A square root of a quantity that lacks a factor: [sqrt (2 * d)], which is not a velocity. *)

val upside_down :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** [a / b] where the unit of [b / a] is expected. *)

val rounded :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A rounded quantity where a plain number is expected: [round (d * 100)]. *)

val gain_of_rate :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A sum with [kd * derivative e], where the unit of the parameter [kd] is wrong. *)

val rate_for_angle :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A literal in radians or degrees per second where an angle is expected. *)
