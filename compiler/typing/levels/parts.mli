(** Searches in expressions, types and patterns. *)

val exists : (Ir.expr -> bool) -> Ir.expr -> bool
(** Does the predicate hold for any name or literal in the expression? *)

val is_static : Ir.ty -> bool
(** Is this the type of a function, signal function or task, or does it contain one? A signal of a
    proc cannot have such a type. *)

val variables : Ir.pattern -> Ir.Local.t list
(** The variables bound by the pattern, last first. *)
