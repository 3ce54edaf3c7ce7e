(** Patterns: that cases cover every value and each branch can be taken.

    Reports cases that lack a value ([E0350]), patterns of functions, procs and equations that do
    not always match ([E0351]), and guards outside of cases that may all fail ([E0352]); warns of
    branches that are never taken ([W0301]). *)

val check : ?sources:Basis.Source.t -> Basis.Diagnostic.sink -> Ir.program -> unit
