(** From equations to a reset and a step function for each node.

    Takes for granted that the program is linted and optimized, so that {!Flow.Schedule} can order
    each node. {!Statics} tells what a node computes when it starts, {!State} what it keeps, {!Body}
    makes its reset and its step of that, {!Start} a short reset and first step in one, and
    {!First_instant} lets the root know its first instant. *)

val program : Flow.Ir.program -> Ir.program
