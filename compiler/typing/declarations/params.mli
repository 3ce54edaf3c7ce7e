(** Parameters of a program: that their types are such as a command line can write. *)

val program : Basis.Diagnostic.sink -> Resolve.Ir.program -> Ir.definition list -> Ir.param list
(** Emits E0390 for a type that is neither a number nor a truth value, or not one type. *)
