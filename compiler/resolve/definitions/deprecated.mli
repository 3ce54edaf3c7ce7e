(** Finds uses of names whose doc comment contains [Deprecated:] and advice after it, such as
    [renamed to `NAME`]. In this way, the library keeps a renamed definition for one version. *)

val warn : Fact.t Basis.Facts.t -> Ir.program -> unit
(** Reports the uses in the program's own modules, except those in definitions that are deprecated
    themselves. *)
