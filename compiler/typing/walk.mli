(** Traversals of typed trees. *)

val parts : (Ir.expr -> unit) -> Ir.expr -> unit
(** Visits the direct subexpressions of an expression, in source order. *)

val own : Resolve.Ir.program -> (Ir.expr -> unit) -> Ir.program -> unit
(** Visits the values of all definitions outside the library. *)
