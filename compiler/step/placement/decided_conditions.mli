(** Folds conditions that are already decided by the branches around them.

    Inside [if (a)], [a] is true, and if [a] was computed as [b && c], [b] and [c] are true too;
    inside the other branch, [a] is false. A value whose constructor the condition has tested has
    that constructor inside the branch. The pass replaces conditions that are known in this way,
    keeps only the branch that can run, and removes the variables that nothing reads any more.

    Only variables are tracked: they never change after their declaration. *)

val statements : Flow.Ir.sum array -> Ir.statement list -> Ir.statement list
(** Folds the decided conditions of a function's body. *)
