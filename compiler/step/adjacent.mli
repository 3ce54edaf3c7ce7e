(** A choice of what is written to the state stands next to its condition.

    Of a condition made of several ([a && b]) C compilers follow each way to the
    choice, and would write whatever stands between the two once for each. So such an
    [If] goes up as far as what it reads and writes allows. *)

val statements : Ir.statement list -> Ir.statement list
