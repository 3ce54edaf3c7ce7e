(** Prints the definitions of the main module, for dumps of Typed.

    The output resembles the source, but shows the level and type of each binding, [run h x] where a
    juxtaposition runs a signal function, and, after [@], the types at which a polymorphic name is
    used. Variables keep their names; if several variables of a definition share a name, the later
    ones get a number. *)

val program : Format.formatter -> Ir.program -> unit
