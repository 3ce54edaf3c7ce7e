(** Values without anything left to evaluate. *)

val evaluate : Value.thunk -> unit
(** To the last part, from outside all evaluation. *)
