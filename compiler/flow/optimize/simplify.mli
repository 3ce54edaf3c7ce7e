(** Constants are computed, copies and choices already made disappear.

    Nothing is rewritten that could change a bit of any output: on Float only identities that hold
    for every value (not [x + 0], which turns -0 into 0). Names that the programmer gave to copies
    go on to what is copied, where that had none. What is asked of a choice between values that are
    known is a choice between answers. Expects no particular order, but sees most in an acyclic
    node; linear. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if nothing in it is simpler. *)

val after : (Ir.node -> Ir.node) -> Ir.program -> Ir.program
(** Where this makes another node of one, that is simplified. *)
