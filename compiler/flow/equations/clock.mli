(** Converts times to whole nanoseconds. *)

open Basis

val nanoseconds : Real.t -> float -> float
(** Converts seconds to nanoseconds (see {!Core.Primitive.elementary}). To round to an integer, adds
    and subtracts a number so large that Floats of that size have no fraction bits. *)

val reaches : Real.t -> float -> int64 option
(** The smallest local time (stored in nanoseconds) that, when converted to seconds and back, is at
    least this number of nanoseconds; [None] if there is none. *)
