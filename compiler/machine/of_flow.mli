(** From equations to a reset and a step function for each node.

    Takes for granted that the program is linted and optimized, so that
    {!Flow.Schedule} can order each node. Local times, integrals advance at
    the start of a step, then values are computed, then results and state are
    written; a derivative advances where it stands. *)

val program : Flow.Ir.program -> Ir.program
