(** The fields of each state in the order of the struct: the largest alignment first, so that
    nothing lies between them, and of one alignment the times last: floats without times between
    them are copied two at once. *)

val program : Ir.program -> Ir.program
