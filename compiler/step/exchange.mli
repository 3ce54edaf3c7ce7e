(** Whether two statements may change places. *)

type touched
(** The variables and fields that a statement reads and sets. *)

val touched : Ir.statement -> touched

val is_plain : Ir.statement -> bool
(** Nothing but values and assignments: no call. *)

val may_exchange : touched -> Ir.statement -> bool
(** Of a plain statement by what it touches, and another one, which is not if it is not
    plain. *)
