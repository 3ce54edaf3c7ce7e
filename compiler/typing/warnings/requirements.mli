(** Warns about constants that a function or a record does not accept, such as negative times and
    limits, and lower limits above upper ones.

    Codes: [W0309] a negative time · [W0316] any other constant. *)

val warn : Fact.t Basis.Facts.t -> Resolve.Ir.program -> Ir.program -> unit
(** Checks the arguments of functions and the fields of records whose doc comments state
    requirements ({!Doc_facts}), in the program's own modules. *)
