(** Warns about constants that are almost certainly mistakes.

    Codes: [W0307] an operation that results in NaN although no operand is NaN · [W0308] a constant
    [Int] that wraps around. *)

val warn : Fact.t Basis.Facts.t -> Resolve.Ir.program -> Ir.program -> unit
(** Checks the definitions of the program's own modules. Does not warn about an intended NaN,
    [0 / 0]. *)
