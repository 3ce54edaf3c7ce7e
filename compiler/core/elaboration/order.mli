(** Sorts definitions in dependency order.

    Typing puts method definitions last; this module moves each one before its uses. Mutually
    recursive definitions keep their order. *)

val definitions : Ir.definition list -> Ir.definition list
(** Linear time. *)
