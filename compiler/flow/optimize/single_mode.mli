(** Replaces a machine that stays in its initial mode with that mode.

    There are two cases. In the first case, the machine never leaves its initial mode; an example is
    a task that drives forever. In the second case, the machine leaves it for a mode that does
    nothing (the end of a task), and the node that runs the machine is itself a mode, which is left
    in the same instant. An example is the task inside [untilRight], which the library uses in
    [watching] and [withMarks]. In this case, all that remains of the end mode is its outputs. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if there is no such machine. *)
