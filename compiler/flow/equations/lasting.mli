(** Which values may outlive the instant: all but those of a foreign type that
    is not copyable, of which C keeps the memory. *)

val of_the_instant : Ir.sum array -> Ir.ty -> Ir.foreign_type option
(** The foreign type in a type that keeps its values from lasting, if any. *)

val mentions_foreign : Ir.sum array -> Ir.shape -> bool
(** Any foreign type, copyable or not. *)
