(** Warns about angles that wrap from pi to -pi but are subtracted or filtered like plain numbers.

    Codes: [W0315]. *)

val warn : Fact.t Basis.Facts.t -> Resolve.Ir.program -> Ir.program -> unit
(** Checks the definitions of the program's own modules. An angle wraps if it is the [heading] of a
    [Pose], or a result of [angleDiff], [direction], [atan2] and similar functions, directly or
    through equations. A difference as an argument of [sin], [angleDiff] and similar functions is
    fine, because these functions accept any number of turns. *)
