(** Converts times to whole nanoseconds. *)

open Basis

val nanoseconds : Real.t -> float -> float
(** Converts seconds to nanoseconds (see {!Core.Primitive.elementary}). To round to an integer, adds
    and subtracts a number so large that Floats of that size have no fraction bits. *)

val reaches : Real.t -> float -> int64 option
(** The smallest local time, as stored in nanoseconds, that is at least this many nanoseconds after
    conversion to seconds and back; [None] if there is none. *)
