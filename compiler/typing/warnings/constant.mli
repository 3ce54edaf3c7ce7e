(** Evaluates constant expressions: arithmetic on literals and on constant definitions. Only for
    warnings, so the values may differ from run-time values in the last bits. *)

type t
(** The constant definitions of a program. *)

val of_program : Ir.program -> t

type value = Float of float  (** in base units *) | Int of int  (** before wraparound *)

val spine : Ir.expr -> Ir.expr * Ir.expr list
(** Splits nested applications into the head and its arguments. *)

val value : t -> Ir.expr -> value option

val is_of_any_numbers : t -> Ir.expr -> bool
(** Does this name have a number-polymorphic definition that is instantiated with Int here? *)

val float : t -> Ir.expr -> float option
(** The value, if it is a [Float]. *)

val operation : Ir.expr -> (string * Ir.expr list) option
(** The name and the arguments, if the expression applies a primitive of the prelude. *)
