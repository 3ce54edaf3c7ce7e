(** What stands where a truth is needed, and is none. *)

val of_events : Show.words -> subject:Resolve.Ir.expr option -> Expected.t -> string option
(** What events have for the operator that wants a truth. *)

val compared : Show.words -> subject:Resolve.Ir.expr option -> Type.t -> string option
(** The cure if it is a number: a comparison. *)
