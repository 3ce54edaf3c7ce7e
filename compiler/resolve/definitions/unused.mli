(** Finds unused names inside definitions, and unused imports: an equation or definition that
    nothing depends on, a pattern variable that nothing reads, an import that the module does not
    use. *)

open Basis

val warn : Fact.t Facts.t -> is_mentioned:(Span.t -> bool) -> Ir.program -> unit
(** Checks the program's own modules. Definitions used only by unused equations are not reported
    separately. Names that begin with [_] are not reported, nor pattern variables at a place that
    satisfies the predicate: places that other warnings mention, because they may explain the unused
    name ([stop] where [Stop] was meant). Do not call it for programs with errors, because an
    unresolved name may be a use of the definition. *)
