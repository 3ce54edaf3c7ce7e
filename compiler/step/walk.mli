(** Traversals of a function's expressions and statements. *)

val children : Ir.expr -> Ir.expr list

val map_children : (Ir.expr -> Ir.expr) -> Ir.expr -> Ir.expr
(** Replaces each of the {!children} of an expression. *)

val expression : (Ir.expr -> unit) -> Ir.expr -> unit
(** Visits an expression, then its subexpressions. *)

val expressions : (Ir.expr -> unit) -> Ir.statement list -> unit
(** Visits each expression and its subexpressions, in the order of the code. *)

val statements : (Ir.statement -> unit) -> Ir.statement list -> unit
(** Visits each statement. An [If] comes before the statements inside it. *)
