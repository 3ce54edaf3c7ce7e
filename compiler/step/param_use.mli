(** Determines which functions of a program read the program's parameters, directly or through a
    callee. *)

type t

val of_program : Ir.program -> t

val in_step : t -> int -> bool
(** Whether the node's step reads parameters. *)

val in_reset : t -> int -> bool
