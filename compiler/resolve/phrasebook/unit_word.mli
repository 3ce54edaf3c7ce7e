(** Units written as words: [metre], [sec], [volts]. *)

val symbol : string -> string option
(** The symbol for the unit word, if it is a unit of the prelude. *)

val is_expression : (Syntax.Ir.name -> bool) -> Syntax.Ir.expr -> bool
(** Would the expression be a unit if it were in brackets? The predicate recognizes unit names. *)

val of_expression : Syntax.Ir.expr -> string
(** The unit as it would be written in brackets. *)
