(** Parameters that always get the same.

    Where all that run a node pass the same for two of its statics or inputs, one of them
    does for both: two functions that have captured one number, or the accumulators of
    [minimumBy id xs], which keeps the nearest element and its key. Twins may be passed on
    as twins, and accumulators may become equal in each round if they are equal before it;
    then they end as one too. {!Dead_code} drops what nobody reads any more. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if all parameters differ. *)
