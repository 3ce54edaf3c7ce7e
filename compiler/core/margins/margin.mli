(** How nearly each assertion held.

    Of each assertion its condition is read, through variables and functions, down to comparisons.
    For each of these the proc gets one more equation, the difference of what is compared, under a
    name that no source can mention; of a condition that compares nothing it is the condition
    itself. Nothing depends on them, as nothing depends on assertions: they are there to be shown.
    And each assertion has a {!Formula} of these columns.

    A comparison of what depends on nothing but time counts as a condition: nothing that a search
    could change makes it come nearer. *)

val program : Ir.program -> Ir.program * (Basis.Span.t -> Formula.t option)
(** And the formula of the assertion that is defined there; [None] if there is none, or where it
    would be too large. *)

val column : string -> int -> string
(** What the equation of that number is called, from the name of the verdict. *)

val is_column : string -> bool
