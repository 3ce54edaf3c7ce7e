(** Evaluates values completely. *)

val evaluate : Value.thunk -> unit
(** Forces a value and all its parts. Must be called outside of any evaluation. *)
