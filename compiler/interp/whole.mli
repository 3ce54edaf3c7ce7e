(** Evaluates values completely. *)

val evaluate : Value.thunk -> unit
(** Forces a value and all its parts. Must not be called during another evaluation. *)
