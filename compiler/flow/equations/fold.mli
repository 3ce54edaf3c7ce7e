(** Operations on constants, computed exactly as the generated C would, in the program's precision.

    So are calls of the runtime's elementary functions ([sin], [pow] …): they have the same bits on
    every machine, and the compiler has them too. *)

val operation : Basis.Real.t -> Ir.operator -> Ir.atom list -> Ir.atom option
(** The constant that the operation gives, if all its arguments are constants and it can be known.
*)
