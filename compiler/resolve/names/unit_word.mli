(** Units written as words: [metre], [sec], [volts]. *)

val symbol : string -> string option
(** The symbol of the unit that the word names, if the prelude has it. *)

val is_expression : (Syntax.Ir.name -> bool) -> Syntax.Ir.expr -> bool
(** Is this a unit, but for the brackets, if these names are units? *)

val of_expression : Syntax.Ir.expr -> string
(** As it would be written in them. *)
