(** Translates Typed to Core.

    Requires a program that has passed the level and pattern checks. The result has no units,
    patterns, guards or records, and each run of a signal function is an equation of a proc.
    Declarations of primitives are dropped, because primitives are built into Core. Linear in the
    size of the program. *)

val program : Typing.Ir.program -> Ir.program
