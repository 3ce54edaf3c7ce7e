(** A function in several clauses, as Haskell has it: Frob has one with a [case]. *)

open Basis

val joined : Ir.declaration list -> Ir.declaration list * Diagnostic.t list
(** The declarations with only the first clause of each function, in order, and what is said of the
    others: one error a function, with the fix that writes the [case]. *)
