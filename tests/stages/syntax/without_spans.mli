(** The same tree with one and the same span everywhere: two programs are the same tree if what
    comes out is equal. *)

val program : Syntax.Ir.program -> Syntax.Ir.program
