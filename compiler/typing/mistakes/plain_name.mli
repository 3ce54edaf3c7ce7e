(** What messages call an expression: the name it is, if it is one. *)

val of_expr : Resolve.Ir.expr -> string option
(** Of a variable or constructor that stands alone. *)

val of_head : Resolve.Ir.expr -> string option
(** Likewise of what is applied to arguments that stand beside it: of [f x y], [f]. *)
