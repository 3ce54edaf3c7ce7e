(** Constants across the borders of nodes.

    A static or input for which every instance of a node passes the same literal becomes that
    literal in the node; so does an output that is a literal in the callers, of a machine if it is
    that in all modes. {!Dead_code} then drops the parameters and outputs that nobody reads. *)

val program : Ir.program -> Ir.program
