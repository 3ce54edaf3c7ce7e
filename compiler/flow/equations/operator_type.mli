(** Types of operators. *)

val result : Ir.operator -> Ir.ty list -> Ir.ty option
(** The result type for these argument types; [None] if the operator does not accept them. *)
