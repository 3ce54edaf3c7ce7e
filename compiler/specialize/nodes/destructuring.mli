(** The programmer's names for the parts of a parameter without a name.

    A tuple pattern as a parameter has become a variable without a name and a binding for each
    variable of the pattern. *)

type t

val none : t
val of_lambda : Types.table -> Value.substitution -> Core.Ir.binder -> Core.Ir.expr -> t
val of_proc : Types.table -> Value.substitution -> Core.Ir.proc -> t

val name : t -> Core.Ir.Local.t -> string -> string
(** Of the leaf at a path of a variable: the leaf [1.x] of the pair [(p, v)] is [p.x]. Empty for
    what no variable of the pattern stands for. *)
