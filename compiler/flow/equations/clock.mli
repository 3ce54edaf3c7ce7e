(** Whole nanoseconds in a time. *)

open Basis

val nanoseconds : Real.t -> float -> float
(** Of seconds, as {!Core.Primitive.elementary} says. Adding and taking away a number from which on
    a Float has no bits for a fraction leaves none. *)

val reaches : Real.t -> float -> int64 option
(** The least local time, in the nanoseconds that are kept, whose seconds have at least so many
    nanoseconds; [None] if none have. *)
