(** Finds equations and definitions that nothing depends on, pattern variables that nothing reads,
    and imports that the module does not use. *)

open Basis

val warn : Fact.t Facts.t -> is_mentioned:(Span.t -> bool) -> Ir.program -> unit
(** Checks the program's own modules. Definitions used only by unused equations are not reported
    separately. Names that begin with [_] are not reported. The predicate recognizes places that
    other warnings mention. Pattern variables there are not reported either, because those warnings
    may explain why the name is unused ([stop] where [Stop] was meant). Do not call it for programs
    with errors, because an unresolved name may be a use of the definition. *)
