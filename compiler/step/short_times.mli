(** Stores local times in 32 bits if the step only compares them with constants.

    For example, [after 2[s]] only needs to know whether its local time has reached 2 s. Such a time
    stays at the largest of the constants, its [bound], so that it fits into 32 bits. Times that are
    shown as numbers, that are divided, or that are compared with numbers known only at run time
    keep 64 bits.

    A time that cannot overflow ({!Ir.Soon}) stays a plain addition. So it is only stored in 32 bits
    if the program only needs to know dt up to 2.1 s. *)

val program : Ir.program -> Ir.program
(** Sets the bounds of the fields. *)

val is_dt_short : Ir.program -> bool
(** Whether the program uses dt in nanoseconds only to advance times that are bounded by 2^31 - 1.
    Then a longer dt has the same effect as one of 2^31 - 1. *)
