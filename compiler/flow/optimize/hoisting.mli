(** Moves elementary functions of unchanged inputs from a node to its callers.

    Two nodes may compute the cosine of the same heading, and the iterations of a loop that of the
    same angle. If the caller computes it and passes the result, it is computed once. A function is
    only moved if this saves a call: if a loop passes the same arguments in all iterations, or if
    the caller would otherwise compute the value more than once. All callers must be able to compute
    it, so the nodes of modes keep theirs. *)

val program : Ir.program -> Ir.program
(** Returns the same program, physically, if nothing was moved. *)
