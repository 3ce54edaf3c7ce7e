(** Warns about unused names inside definitions, and about unused imports.

    Codes: [W0304] an equation or definition that nothing depends on · [W0305] a pattern variable
    that nothing reads · [W0306] an import that the module does not use. *)

val warn : Basis.Diagnostic.sink -> Ir.program -> unit
(** Checks the program's own modules. Definitions used only by unused equations are not reported
    separately. Names that begin with [_] are not reported. Do not call it for programs with errors,
    because an unresolved name may be a use of the definition. *)
