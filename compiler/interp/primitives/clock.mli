(** Time, counted in whole nanoseconds (language reference, section 3). *)

type instant = int64
(** Nanoseconds since the previous instant; 0 in the first instant of a signal function. *)

val first : instant

val after : Basis.Real.t -> float -> instant
(** The instant that comes this many seconds after the previous one. The number of seconds has the
    given precision. Rounds to the nearest nanosecond, ties to even. Returns 0 for negative numbers
    and NaN, and never more than 10⁹ s. In single precision, the fractional part of the seconds is
    multiplied by 10⁹, and the product is rounded to a single as well. Therefore the single nearest
    to 0.1 becomes 100,000,000 ns, although it is 1.5 ns longer than that. *)

val later : int64 -> instant -> int64
(** Adds the length of an instant to a local time in nanoseconds. Saturates at 2⁶³ - 1 ns, about 292
    years. *)

val seconds : Basis.Real.t -> int64 -> float
(** Converts nanoseconds to seconds: rounds them to the precision of the program, then divides by
    10⁹. *)
