(** Constant propagation between nodes.

    If every instance of a node passes the same literal for a static parameter or input, the node
    uses the literal. If an output of a node is a literal, its callers use the literal; for a
    machine, it must be the same literal in all modes. {!Dead_code} then removes the parameters and
    outputs that are no longer read. *)

val program : Ir.program -> Ir.program
