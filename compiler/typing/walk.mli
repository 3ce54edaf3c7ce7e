(** Traversals of typed trees. *)

val children : Ir.expr -> Ir.expr list
(** The direct subexpressions, in source order. *)

val parts : (Ir.expr -> unit) -> Ir.expr -> unit
(** Visits the {!children} of an expression. *)

val patterns : Ir.expr -> Ir.pattern list
(** The patterns that an expression itself binds, in source order: parameters, and the patterns of
    branches, bindings and equations. *)

val own : Resolve.Ir.program -> (Ir.expr -> unit) -> Ir.program -> unit
(** Visits the values of all definitions outside the library. *)
