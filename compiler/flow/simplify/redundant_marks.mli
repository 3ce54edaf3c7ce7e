(** Removes tests for the first instant that make no difference.

    [delay False True] is False in the first instant only. So [delay False True && x] equals [x] if
    [x] is known to be False in the first instant, as in [every 1[s] ()]: its ticks cannot occur
    then, because no time has passed. *)

val program : Ir.program -> Ir.program
