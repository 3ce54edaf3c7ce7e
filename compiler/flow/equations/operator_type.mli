(** What operators take and give. *)

val result : Ir.operator -> Ir.ty list -> Ir.ty option
(** Of arguments of these types; [None] if it does not take such. *)
