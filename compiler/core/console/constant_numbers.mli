(** Finds the variables that a knob's limits depend on.

    A specialization takes numbers as parameters. However, the limits and the initial value of a
    knob and the initial position of a toggle must be known at compile time, and so must the
    variables that they are computed from. *)

type t

val of_program : Ir.program -> t
(** Finds all these variables by tracing them through functions and definitions, whatever the order
    of the definitions. *)

val has : t -> Ir.Local.t -> bool
