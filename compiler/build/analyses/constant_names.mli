(** Finds where a program uses its named constants, so that generated C can use their names.

    A constant is a top-level or local definition in the user's own modules whose value is a number
    that the compiler knows: [kSide = -1.2[1/s]]. Literals lose their origin when the program is
    specialized, but operations keep their places. A number in C therefore gets a name only if the
    operation at its place is written with the constant itself as an operand, and the constant has
    exactly this value. It gets no name if another operand of that operation has the same value, or
    if the constant is passed on as an argument of a function. *)

val of_program : resolved:Resolve.Ir.program -> Typing.Ir.program -> Cgen.Named_constants.t
