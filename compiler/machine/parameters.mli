(** How much a function of the generated C is given one by one. *)

val most : int
(** More parameters than this, results included, are members of structs. C99 promises
    127 of a function, and no compiler tells if there are more; long before that a
    person no longer sees which is which. *)
