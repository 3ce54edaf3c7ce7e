(** What is computed of a parameter that is always a literal is computed by the
    compiler, and passed in its place.

    A mode that several others enter with 1 s and 2 s ([sleepT]) gets these as a
    parameter, of which it then needs the whole nanoseconds only; one that is
    entered with angles may need no more than their sines. So a static parameter
    for which only literals are passed, and of which the node reads a single
    signal that is computed of it and of constants alone, is replaced by that
    signal. A parameter for which always the same literal is passed is none
    ({!Specific}). Expects no dead nodes. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there was nothing to replace. *)

val passed : Ir.program -> Ir.signal -> Ir.atom list option
(** What the calls of a node, or the transitions into it, pass for one of its statics, if
    that is nothing but literals. *)
