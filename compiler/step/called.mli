(** Which functions of a program anything calls. *)

type t

val of_program : Ir.program -> t

val reset : t -> int -> bool
(** The reset of a node; that of the root too. *)

val start : t -> int -> bool
