(** Transitions that cannot occur, and modes that nothing leads to, disappear.

    What is written in a mode only for such a transition is left to {!Dead_code}. *)

val program : Ir.program -> Ir.program
