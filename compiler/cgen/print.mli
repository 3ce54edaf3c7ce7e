(** C as text: four spaces of indentation, lines of at most about 96 columns
    where expressions can be broken, comments at the end of statements. *)

val file : Ir.file -> string

val float_literal : float -> string
(** The shortest decimal that reads back as exactly this number. *)
