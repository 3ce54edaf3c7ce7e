(** Written when the compiler is built, by [prepare/prepare.ml]. *)

val all : (string * string * string) list
(** For each module of the library the file as diagnostics show it, its text, and its tree (a
    {!Syntax.Ir.program}), marshalled. *)
