(** A machine that is all the state of its one user becomes that node's own.

    So a program that is a switch is one struct with the tag in it, and no step that only calls
    another. Expects no dead nodes. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there is no such machine. *)
