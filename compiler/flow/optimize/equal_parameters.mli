(** Parameters that always get the same.

    Where all that run a node pass the same for two of its statics or inputs, one of them does for
    both: two functions that have captured one number. Twins may be passed on as twins; a loop's
    accumulators are none. {!Dead_code} drops what nobody reads any more. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if all parameters differ. *)
