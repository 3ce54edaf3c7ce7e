(** Replaces a machine that stays in its initial mode by that mode.

    There are two kinds. The first is a machine that never leaves its initial mode, such as a task
    that drives for ever. The second leaves it for a mode that does nothing, the end of a task, and
    its user is itself a mode that is left at the same instant: an example is the task inside
    [untilRight], which the library uses in [watching] and [withMarks]. In this case only the
    outputs of the end are kept. *)

val program : Ir.program -> Ir.program
(** Returns the same program, physically, if there is no such machine. *)
