(** Warns about constants that are almost certainly mistakes.

    Codes: [W0307] a number that is NaN although its operands are not · [W0308] a constant [Int]
    that wraps around. *)

val warn : Fact.t Basis.Facts.t -> Resolve.Ir.program -> Ir.program -> unit
(** Checks the definitions of the program's own modules. Does not warn about an intended NaN,
    [0 / 0]. *)
