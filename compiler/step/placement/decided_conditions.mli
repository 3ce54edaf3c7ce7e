(** Folds conditions that the branches around them have decided.

    Inside [if (a)], [a] is true, and so are both operands of an [a] that was computed as [b && c];
    inside the other branch it is false. A value whose constructor a branch has tested has that
    constructor there. The pass replaces conditions that are known in this way, keeps only the
    branch that can run, and removes the variables that nothing reads any more.

    Only variables are tracked: they never change after their declaration. *)

val statements : Flow.Ir.sum array -> Ir.statement list -> Ir.statement list
(** Folds the decided conditions of a function's body. *)
