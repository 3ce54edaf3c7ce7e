(** Syntax as Frob source.

    What is printed parses to the same tree, but for spans: blocks stand on lines of their own, two
    columns further right than the line that opens them. Comments that document nothing are gone. *)

val program : Format.formatter -> Ir.program -> unit

(** Parts of a program in one line, for messages. *)

val ty : Ir.ty -> string
