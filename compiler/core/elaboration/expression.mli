(** Expressions of Typed as expressions of Core.

    An expression stands either at a place of a proc that is computed at every instant, or
    elsewhere. At the former, each instance becomes an equation of its own and so does each
    [let]-bound variable, for the instances may depend on it; levels guarantee that the latter holds
    no instance. *)

val closed :
  Context.t -> Lifting.table -> name:Ir.Global.t -> Ir.variable list -> Typing.Ir.expr -> Ir.expr
(** The value of a top-level definition of that name, with these type parameters. What is lifted out
    of it is defined in the context. *)
