(** The laws of the formatter. This module checks a program and its formatted version with
    independent means: it compares the trees, and finds comments with a scanner that recognizes only
    comments and strings. *)

val parsed : string -> Syntax.Ir.program option
(** The tree without spans. *)

val verdict : string -> (string, string) result
(** For a valid program: the formatter's result, or the law that it breaks. *)
