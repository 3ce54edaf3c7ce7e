(** Constants that nobody means.

    Codes: [W0307] a number that is NaN, though what it is made of is not · [W0308] a constant [Int]
    that wraps around · [W0309] a time below zero where a duration is wanted. *)

val warn : Basis.Diagnostic.sink -> Resolve.Ir.program -> Ir.program -> unit
(** In the definitions of the program's own modules. NaN on purpose, [0 / 0], is silent. *)
