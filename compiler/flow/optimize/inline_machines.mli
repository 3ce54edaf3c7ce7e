(** Moves a machine into the only node that uses it, if that node has no other state. For a program
    that is a single switch, the generated C then has one struct that contains the mode's tag, and
    no step function that only calls another one. Requires that there are no dead nodes. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if there is no such machine. *)
