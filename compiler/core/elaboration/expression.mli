(** Translates expressions of Typed to expressions of Core.

    An expression occurs either in a part of a proc that is evaluated at every instant, or
    elsewhere. In the first case, each instance becomes a separate equation, and so does each
    [let]-bound variable, because instances may depend on it. In the second case, the levels
    guarantee that there are no instances. *)

val closed :
  Context.t -> Lifting.table -> name:Ir.Global.t -> Ir.variable list -> Typing.Ir.expr -> Ir.expr
(** The value of the top-level definition with this name and these type parameters. Definitions
    lifted out of it are added to the context. *)
