(** The name by which messages refer to an expression. *)

val of_expr : Resolve.Ir.expr -> string option
(** The name, if the expression is a variable or a constructor. *)

val of_head : Resolve.Ir.expr -> string option
(** Like {!of_expr}, for the head of a juxtaposition: [f] for [f x y]. *)
