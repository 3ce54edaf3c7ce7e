(** A machine that goes on only in the mode that it starts with is that mode.

    Two machines are so. One is never left, as that of a task that drives for ever. The other is
    left for a mode in which nothing goes on, the end of a task, and whoever runs it is itself a
    mode that is left at that very instant: the task inside [untilRight], of which [watching] and
    [withMarks] are made. Of the end only what it puts out matters then. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there is no such machine. *)
