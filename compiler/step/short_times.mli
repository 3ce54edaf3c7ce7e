(** Stores local times in 32 bits if the step only compares them with constants.

    For example, [after 2[s]] only needs to know whether its local time has reached 2 s. Such a time
    stops at its [bound], the largest of the constants, so that it fits into 32 bits. Times that are
    shown as numbers, that are divided, or that are compared with numbers known only at run time
    keep 64 bits. *)

val program : Ir.program -> Ir.program
(** Sets the bounds of the fields. *)

val reached : Basis.Real.t -> Ir.node -> Ir.field list
(** The fields that the node's step advances at top level and compares with their bounds in a later
    statement. *)

val only_advances : Ir.program -> Ir.node -> bool
(** Whether the node's step, without its callees, uses dt in nanoseconds only to advance bounded
    times. *)
