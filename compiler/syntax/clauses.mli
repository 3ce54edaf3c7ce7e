(** Detects functions that are defined by several clauses, as in Haskell. A Frob function has only
    one clause, which can contain a [case]. *)

val joined : Ir.declaration list -> Ir.declaration list * Rejection.t list
(** Keeps only the first clause of each function. Returns the remaining declarations in order, and,
    for each function with several clauses, the reason to reject its other clauses. *)
