(** Constants across the borders of nodes.

    A static or input for which every instance of a node passes the same
    literal becomes that literal in the node; an output that is a literal or
    one of the node's own parameters is replaced in the callers by what it is
    there. {!Dead_code} then drops the parameters and outputs that nobody reads. *)

val program : Ir.program -> Ir.program
