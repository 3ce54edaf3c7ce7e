(** Replaces a machine that stays in its initial mode with that mode.

    There are two cases. In the first case, the machine never leaves its initial mode; an example is
    a task that drives forever. In the second case, the machine leaves it for a mode that does
    nothing (the end of a task), and the machine's user is itself a mode that is left in the same
    instant. An example is the task inside [untilRight], which the library uses in [watching] and
    [withMarks]. In this case, only the outputs of the end mode are kept. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if there is no such machine. *)
