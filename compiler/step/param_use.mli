(** Which functions of a program read its parameters, or call one that does. *)

type t

val of_program : Ir.program -> t

val in_step : t -> int -> bool
(** The node's step. *)

val in_reset : t -> int -> bool
