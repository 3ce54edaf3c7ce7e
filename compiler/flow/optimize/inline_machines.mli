(** Moves a machine that is the whole state of its only user into that user.

    A program that is one switch then has one struct that contains the mode's tag, and no step
    function that only calls another. Requires that there are no dead nodes. *)

val program : Ir.program -> Ir.program
(** Returns the same program, physically, if there is no such machine. *)
