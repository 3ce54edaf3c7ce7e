(** Functions defined by several clauses, as in Haskell. A Frob function has one clause, which can
    contain a [case]. *)

val joined : Ir.declaration list -> Ir.declaration list * Rejection.t list
(** The declarations with only the first clause of each function, in order, and the reasons to
    reject the others: one per function. *)
