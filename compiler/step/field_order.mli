(** Sorts the fields of each state for the layout of the struct. Fields with the largest alignment
    come first, so that no padding is needed between fields. Within one alignment, times come last:
    compilers copy two adjacent floats at once if no time is between them. *)

val program : Ir.program -> Ir.program
