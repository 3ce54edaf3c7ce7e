(** Modes' parameters that are times in whole nanoseconds, as integers.

    A mode that waits as long as its parameter says ([sleepT], entered with 1 s and
    with 2 s) compares its time in nanoseconds with a Float. Where that is all it does
    with the parameter, and all that enter the mode give literals, the parameter
    becomes the least number of nanoseconds that is enough ({!Flow.Clock.reaches}),
    which is quicker to compare, and smaller where there are no registers for Floats. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there is no such parameter. *)
