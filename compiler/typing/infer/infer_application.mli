(** Infers juxtapositions: a function is applied, or a signal function is run.

    The type of the head determines which of the two it is. While that type is unknown, the decision
    is postponed, at most until the end of the top-level group. If the type is still unknown then,
    the head is treated as a function. *)

open Context

val infer : expressions -> t -> Resolve.Ir.expr -> typed
(** For an [Apply]; handles all nested applications together. *)
