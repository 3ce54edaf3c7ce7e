(** Moves calls to elementary functions from a node to its callers if the arguments are inputs of
    the node.

    For example, two nodes may compute the cosine of the same heading, or all iterations of a loop
    may compute the cosine of the same angle. If the caller computes the cosine and passes the
    result, it is computed only once. The pass moves a call only if this reduces the number of
    calls: if a loop passes the same arguments in all iterations, or if the caller would otherwise
    compute the value more than once. All callers must be able to compute the value, so nothing is
    moved out of the nodes of modes. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if nothing was moved. *)
