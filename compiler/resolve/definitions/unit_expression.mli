(** Recognizes expressions that would be units if they were in brackets. *)

val is_unit : (Syntax.Ir.name -> bool) -> Syntax.Ir.expr -> bool
(** The predicate recognizes the names of units. *)
