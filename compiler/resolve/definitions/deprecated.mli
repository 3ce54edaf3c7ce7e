(** Finds uses of names whose doc comment contains [Deprecated:] and advice after it, such as
    [renamed to `NAME`]. In this way, the library keeps a renamed definition for one version. *)

val warn : Fact.t Basis.Facts.t -> Ir.program -> unit
(** Checks the program's own modules. Uses in a deprecated definition are not reported. *)
