(** How what enters a mode begins it. *)

val given : (Ir.code * Ir.expr list) list -> Ir.code -> Ir.expr list
(** The arguments of code whose parameters are among those of others, whose arguments are
    there; where two of these have one, that of the first. *)

val started : callee:(int -> Ir.node) -> Ir.mode list -> Ir.run -> Ir.entry -> Ir.entry
(** The same entry for what enters the mode and steps it at once ({!Direct}): by the start
    of its node, if there is one. *)
