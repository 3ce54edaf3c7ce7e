(** The first instant, whose dt is to be 0 wherever it shows.

    It shows in all that reads dt but an integral of what was before, which is 0 then, and in what
    shows it of the nodes that are stepped at the first instant: of a machine those are the modes
    that it starts with; what these lead to is entered, with a dt of 0. *)

val program : Ir.program -> Ir.program
(** The program with the {!Ir.mark} that tells the root's first step, if its dt shows: a delay that
    the program has anyway, or else a field of its own. *)
