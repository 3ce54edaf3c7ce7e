(** Infers juxtapositions: a function is applied, or a signal function is run.

    The type of the head determines which one it is. While that type is unknown, the decision is
    postponed, at most until the end of the top-level group. A head that is unknown even then is
    taken to be a function. *)

open Context

val infer : expressions -> t -> Resolve.Ir.expr -> typed
(** For an [Apply]; treats all nested applications at once. *)
