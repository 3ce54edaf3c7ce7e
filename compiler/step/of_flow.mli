(** Translates the equations of each node to a reset and a step function.

    The program must be linted and optimized, so that {!Flow.Schedule} can order each node.
    {!Statics} decides what a node computes when it starts, {!State} allocates its fields, {!Body}
    builds the reset and the step, and {!First_instant} lets the root recognize its first instant.
*)

val program : Flow.Ir.program -> Ir.program
