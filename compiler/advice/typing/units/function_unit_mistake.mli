(** Messages about units that do not fit one particular function, such as a frequency as the
    argument of [sin]. *)

open Typing

val complete : Unit_rule.t
(** Adds the hint for the function that takes this argument, if there is one for that function. *)

val power : Wording.t -> expected:Expected.t -> ?unit_:string -> unit -> Unit_rule.complete option
(** [d ** 2] for a base [d] that `**` does not accept, because it has a unit or is an `Int`. *)

val whole_numbers : Wording.t -> expected:Expected.t -> found:Type.t -> Unit_rule.complete option
(** Numbers with a fractional part as arguments of [mod] or [div]. *)

val quotient : Wording.t -> expected:Expected.t -> Unit_rule.complete option
(** Whole numbers as operands of [/]. *)
