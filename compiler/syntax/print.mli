(** Prints a syntax tree as Frob source.

    The output parses to the same tree, apart from spans. Blocks are on separate lines, indented two
    columns more than the line that opens them. Comments other than doc comments are lost. *)

val program : Format.formatter -> Ir.program -> unit
