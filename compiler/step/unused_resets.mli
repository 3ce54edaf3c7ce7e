(** Removes resets that are never called. For example, a machine nested in a mode needs a reset only
    if something enters that mode. *)

val program : Ir.program -> Ir.program
