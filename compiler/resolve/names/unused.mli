(** What is bound inside of a definition and never used.

    Codes: [W0304] an equation or definition that nothing depends on, [W0305] a variable of a
    pattern that nothing reads, [W0306] an import of which nothing is used. *)

val warn : Basis.Diagnostic.sink -> Ir.program -> unit
(** Of the program's own modules. What only unused equations use is not reported besides them. A
    name that begins with [_] is silent. Not for programs with errors: a name that is unknown may be
    the use. *)
