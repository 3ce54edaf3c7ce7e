(** Ensures that dt is 0 in the first instant wherever this can be observed.

    It can be observed in every expression that reads dt, except in an integral, whose previous
    input is 0 then, and in those nodes stepped in the first instant in which it can be observed.
    For a machine, these are the modes it may start with; modes that follow them are entered with a
    dt of 0 anyway. *)

val program : Ir.program -> Ir.program
(** If dt can be observed, adds the {!Ir.mark} of the root's first step to the program. The mark is
    a delay that the program already has, or else a new field. *)
