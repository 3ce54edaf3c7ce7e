(** Removes transitions that cannot occur, and modes that are never entered.

    {!Dead_code} removes the equations that a mode only needs for such a transition. *)

val program : Ir.program -> Ir.program
