(** Finds equations and definitions that nothing depends on, pattern variables that nothing reads,
    and imports that the module does not use. *)

open Basis

val warn : Fact.t Facts.t -> is_mentioned:(Span.t -> bool) -> Ir.program -> unit
(** Checks the program's own modules. Does not report names that begin with [_], or definitions used
    only by unused equations. Nor does it report pattern variables in places where [is_mentioned] is
    true: other warnings mention these places and may explain why the name is unused ([stop] where
    [Stop] was meant). The program must not have errors, because an unresolved name may be a use of
    a definition. *)
