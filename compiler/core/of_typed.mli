(** Typed into Core.

    Takes for granted that levels and patterns were checked without an error. Afterwards there are
    no units, patterns, guards and records, and each run of a signal function is an equation of a
    proc. Linear in the program's size; primitives lose their declarations, for Core knows them. *)

val program : Typing.Ir.program -> Ir.program
