(** Warns about names whose doc comment says that they are deprecated.

    If the doc comment contains the sentence [Deprecated: renamed to `NAME`.], the warning has a fix
    that writes the new name. If it contains [Deprecated:] and other advice, the advice becomes the
    hint. In this way, the library keeps a renamed definition for one version.

    Code: [W0317]. *)

val warn : Basis.Diagnostic.sink -> Ir.program -> unit
(** Checks the program's own modules. Uses in a deprecated definition are not reported. *)
