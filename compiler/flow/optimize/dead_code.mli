(** What no output of the program depends on disappears: equations, instances, statics, inputs and
    outputs of nodes, and nodes.

    A node's parameter is needed if what is needed in the node reads it, at whatever instant; what
    is passed for it, in the instances that are needed. All of it is one search from the outputs of
    the root, linear in the size of the program. The root's own inputs and outputs stay: they are
    the interface. *)

val program : Ir.program -> Ir.program
