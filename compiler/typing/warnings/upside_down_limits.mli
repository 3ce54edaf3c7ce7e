(** Warns of constant limits, rates and frequencies below zero, and of lower limits above upper
    ones.

    Codes: [W0316]. *)

val warn : Basis.Diagnostic.sink -> Resolve.Ir.program -> Ir.program -> unit
(** Checks the arguments of functions in the modules Control, Filters and Angles, and the fields of
    [Pid] and [PidSettings], in the program's own modules. *)
