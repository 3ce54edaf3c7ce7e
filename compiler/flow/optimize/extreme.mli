(** The least or largest number that a loop looks for.

    [minimumBy id] and [maximumBy id] fold the smaller or larger of an accumulator
    and an element, and a number rather than NaN: that takes a test whether there
    was a number before. They start from the first element; if that comes out of
    another loop, they cannot be joined with it. *)

val program : Ir.program -> Ir.program
(** Such a loop starts from NaN. Where what is done with the number that is found is the
    same for NaN and for an infinity, as in [minimumBy id xs < 1], it starts from that
    infinity, and needs no test if its node is no other loop's.
    Physically the same program if there is nothing to do. *)
