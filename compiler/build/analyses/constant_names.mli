(** Finds where a program uses its named constants, so that generated C can use their names.

    A constant is a top-level or local definition in the user's own modules whose value is a number
    that the compiler knows: [kSide = -1.2[1/s]]. Specialization loses the origins of literals, but
    keeps the source locations of operations. Therefore, generated C uses a constant's name for a
    number only if the constant itself is an operand of that operation in the source and has exactly
    this value. It does not use the name if another operand of the operation has the same value, or
    if the constant is passed to a function as an argument. *)

val of_program : resolved:Resolve.Ir.program -> Typing.Ir.program -> Cgen.Named_constants.t
