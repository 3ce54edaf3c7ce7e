(** Typed as text, for dumps: the definitions of the main module.

    Like the source, but with the level and type of each binding, with [run h x] where a
    juxtaposition runs a signal function, and with the types at which a polymorphic name is used
    after [@]. Variables keep their names; of several with one name in a definition the later ones
    get a number. *)

val program : Format.formatter -> Ir.program -> unit
