(** Which variables a knob's limits are made of.

    Numbers are parameters of what is compiled; those that come to be the limits or the first value
    of a knob, or the first position of a toggle, have to be known while compiling, and so have the
    variables on their way there. *)

type t

val of_program : Ir.program -> t
(** All of them, through functions and definitions, whatever their order. *)

val has : t -> Ir.Local.t -> bool
