(** Numbers that an expression is whatever happens, as far as arithmetic with literals and with
    definitions of such tells; for warnings, so not to the last bit. *)

type t
(** What is known of a program's definitions. *)

val of_program : Ir.program -> t

type value = Float of float  (** in base units *) | Int of int  (** before it wraps around *)

val spine : Ir.expr -> Ir.expr * Ir.expr list
(** What is applied, and to what. *)

val value : t -> Ir.expr -> value option

val is_of_any_numbers : t -> Ir.expr -> bool
(** A name of a definition whose numbers are Ints only where it is used. *)

val float : t -> Ir.expr -> float option
(** Of a [Float] only. *)

val operation : Ir.expr -> (string * Ir.expr list) option
(** A primitive of the prelude applied to arguments. *)
