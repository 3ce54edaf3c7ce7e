(** Warns about names whose doc comment says that they are deprecated.

    A doc comment contains the sentence [Deprecated: renamed to `NAME`.], and the warning has the
    fix that writes the new name; or [Deprecated:] and advice, which becomes the hint. A name that
    changes stays in the library for one version in this way.

    Code: [W0317]. *)

val warn : Basis.Diagnostic.sink -> Ir.program -> unit
(** Checks the program's own modules. Uses in a deprecated definition are not reported. *)
