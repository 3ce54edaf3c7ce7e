(** Finds uses of names whose doc comment contains [Deprecated:] followed by advice, such as
    [renamed to `NAME`]. When the library renames a definition, it keeps the old name for one
    version, marked in this way. *)

val warn : Fact.t Basis.Facts.t -> Ir.program -> unit
(** Reports the uses in the program's own modules, except those in definitions that are deprecated
    themselves. *)
