(** Functions defined by several clauses, as in Haskell. A Frob function has one clause, which can
    contain a [case]. *)

open Basis

val joined : Ir.declaration list -> Ir.declaration list * Diagnostic.t list
(** The declarations with only the first clause of each function, in order, and the errors for the
    other clauses: one per function, with a fix that writes the [case]. *)
