(** Numbers that cause a unit mismatch elsewhere: in the definition of a function without a
    signature, or in the branches of a choice.

    Each rule returns a function that labels the numbers in a message and suggests their units. *)

open Typing

val chosen : Unit_rule.t
(** The value is one of several numbers, such as [speed d] with
    [speed d = if d > 1[m] then 0.3 else 0.1]. *)

val scaled : Wording.t -> Resolve.Ir.expr -> Units.t * Units.t -> Unit_rule.complete option
(** The value is the product of a number, which determines the unit, and plain numbers:
    [0.4[m/s] * side]. *)

val compared : Wording.t -> expected:Expected.t -> Units.t * Units.t -> Unit_rule.complete option
(** The function compares its parameter with a number or adds a number to it: [near d = d < 0.4]. *)
