(** Evaluates values completely. *)

val evaluate : Value.thunk -> unit
(** Forces a value and all its parts. Call this outside of any evaluation. *)
