(** Accumulators that are always equal become one.

    `minimumBy id` folds a pair of an element and its key, which are the same.
    Two accumulators of a loop are twins if they start with the same value and
    each round gives them equal values where they were equal before. Looks at
    nodes that only one loop runs. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there are none. *)
