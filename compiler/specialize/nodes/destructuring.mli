(** Finds the programmer's names for the parts of an unnamed parameter.

    An earlier stage has translated a tuple pattern in parameter position into an unnamed variable
    and one binding for each variable of the pattern. *)

type t

val none : t
val of_lambda : Types.table -> Value.substitution -> Core.Ir.binder -> Core.Ir.expr -> t
val of_proc : Types.table -> Value.substitution -> Core.Ir.proc -> t

val name : t -> Core.Ir.Local.t -> string -> string
(** The name of a variable's leaf, given the leaf's path. For example, the leaf [1.x] of the pair
    [(p, v)] is called [p.x]. The empty string if no variable of the pattern contains the leaf. *)
