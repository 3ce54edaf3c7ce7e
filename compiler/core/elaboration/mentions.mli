(** Finds the free variables of a Typed expression. *)

type t = {
  variables : Ir.binder list;  (** without duplicates, in order of first occurrence *)
  runs : bool;  (** whether it contains an instance that belongs to the enclosing proc *)
}

val of_expr : Typing.Ir.expr -> t
