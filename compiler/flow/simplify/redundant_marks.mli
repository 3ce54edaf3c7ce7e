(** Removes redundant tests for the first instant.

    [delay False True] is False in the first instant only. So [delay False True && x] equals [x] if
    [x] is known to be False in the first instant. This holds for the ticks of [every 1[s] ()],
    which cannot occur then because no time has passed. *)

val program : Ir.program -> Ir.program
