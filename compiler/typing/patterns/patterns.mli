(** Checks that patterns are exhaustive and that each branch can be taken.

    Reports non-exhaustive cases ([E0350]), refutable patterns in functions, procs and equations
    ([E0351]), and guards outside of cases that may all fail ([E0352]). Warns of unreachable
    branches ([W0301]). *)

val check : ?sources:Basis.Source.t -> Basis.Diagnostic.sink -> Ir.program -> unit
