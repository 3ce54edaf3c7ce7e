(** Checks that patterns are exhaustive and that each branch is reachable.

    Reports non-exhaustive cases ([E0350]), refutable patterns in functions, procs and equations
    ([E0351]), and guards outside a [case] that can all be false ([E0352]). Warns about unreachable
    branches ([W0301]). *)

val check : Fact.t Basis.Facts.t -> Ir.program -> unit
