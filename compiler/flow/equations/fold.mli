(** Constant folding: computes operations on constants exactly as the generated C would, in the
    program's precision. This includes the runtime's elementary functions ([sin], [pow] …), which
    return the same bits on every machine and are also part of the compiler. *)

val operation : Basis.Real.t -> Ir.operator -> Ir.atom list -> Ir.atom option
(** The result of an operation, if all its arguments are constants of types that it accepts. *)
