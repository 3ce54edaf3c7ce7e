(** Warns about divisions by the length of the step, which is 0 at the first instant.

    Codes: [W0314]. *)

val warn : Fact.t Basis.Facts.t -> Resolve.Ir.program -> Ir.program -> unit
(** Checks the definitions of the program's own modules. Does not warn about a division in a branch,
    because the branch may not be taken at the first instant. *)
