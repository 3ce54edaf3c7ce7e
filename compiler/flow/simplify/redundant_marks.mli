(** Removes redundant tests for the first instant.

    [delay False True] is False in the first instant only. So [delay False True && x] equals [x] if
    [x] is known to be False in the first instant. For example, [x] may be the ticks of
    [every 1[s] ()], which cannot occur in the first instant, because no time has passed. *)

val program : Ir.program -> Ir.program
