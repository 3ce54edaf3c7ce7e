(** Simplifies conditions that are equivalent to [a], [not a], [a && b] or [a || b] for one or two
    other signals.

    For example, [mergeE] distinguishes three cases even if the program only needs to know whether
    one of two events occurs. Candidates are verified for all values of the two signals. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if there is no such condition. *)
