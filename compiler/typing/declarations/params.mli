(** Checks that parameters of a program have types whose values can be written on a command line. *)

val program : Basis.Diagnostic.sink -> Resolve.Ir.program -> Ir.definition list -> Ir.param list
(** Emits E0390 for a type that is neither a number nor a truth value, or that is polymorphic. *)
