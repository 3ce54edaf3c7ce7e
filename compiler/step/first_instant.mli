(** The first instant, whose dt is to be 0 wherever it shows.

    It shows in all that reads dt, and in what shows it of the nodes that are stepped at the first instant: of a machine those
    are the modes that it starts with; what these lead to is entered, with a dt of 0. *)

val program : Ir.program -> Ir.program
(** The program with the field that tells the root's first step, if its dt shows. *)
