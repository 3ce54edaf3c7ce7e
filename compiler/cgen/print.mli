(** Prints C: four spaces of indentation, lines of at most about 96 columns where expressions can be
    broken, comments at the ends of statements. *)

val file : Ir.file -> string

val real_name : Basis.Real.t -> string
(** The name of the type in C. *)

val real_suffix : Basis.Real.t -> string
(** The suffix of literals and of mathematical functions. *)

val float_literal : Basis.Real.t -> float -> string
(** The shortest decimal that reads back as exactly this number. *)
