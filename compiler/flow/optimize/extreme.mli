(** The least or largest number that a loop looks for.

    [minimumBy id] and [maximumBy id] fold the smaller or larger of an accumulator
    and an element, and a number rather than NaN: that takes a test whether there
    was a number before. *)

val program : Ir.program -> Ir.program
(** Where what is done with the number that is found is the same for NaN and for an
    infinity, as in [minimumBy id xs < 1], the loop starts from that infinity, and
    so needs no test. Takes loops that start from their first element. Looks at nodes
    that only one loop runs.
    Physically the same program if there is nothing to do. *)
