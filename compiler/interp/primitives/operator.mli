(** The operator's console: a record with a field for each thing on it, by its label. *)

val apply : Core.Ir.control list -> Core.Primitive.console -> Value.thunk list -> Value.t
(** On all arguments; the console is the last. *)

val at_rest : Core.Ir.control list -> Value.t
(** The console that nobody touches. *)

val control_at_rest : Core.Ir.control -> Value.t
(** One thing on it. *)
