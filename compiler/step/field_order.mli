(** Sorts the fields of each state for the layout of the struct. Fields with the largest alignment
    come first, so that no padding is needed between fields. Among fields with the same alignment,
    times come last: compilers copy two adjacent floats with one instruction if no time is between
    them. *)

val program : Ir.program -> Ir.program
