(** Computes the margins of assertions: how close each condition was to changing.

    The condition of each assertion is analysed, through variables and functions, down to
    comparisons. For each comparison the proc gets an additional equation, whose value is the
    difference of the operands and whose name cannot occur in source code. For a condition without
    comparisons, the value is the condition itself. Like assertions, these equations have no
    dependents; they exist only to be recorded. Each assertion also gets a {!Formula} over these
    columns.

    A comparison that depends only on time counts as a plain condition, because no change of the
    inputs can bring it closer. *)

val program : Ir.program -> Ir.program * (Basis.Span.t -> Formula.t option)
(** Adds these equations to the program. Also returns a function that maps the place of an assertion
    to its formula; [None] if there is no assertion at that place or its formula would be too large.
*)

val column : string -> int -> string
(** The name of the equation with this number, derived from the name of the verdict. *)

val is_column : string -> bool
