(** The reset of what nothing resets is left out: of the root's machines within machines only those
    that a mode starts with, or that something enters, have one. *)

val program : Ir.program -> Ir.program
