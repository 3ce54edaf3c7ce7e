(** Time: counted in whole nanoseconds (language reference, section 3). *)

type instant = {
  ns : int64;  (** since the instant before; 0 at a signal function's first *)
  dt : float;  (** the same in seconds: [ns] divided by 10⁹ *)
}

val first : instant

val after : float -> instant
(** An instant that many seconds after another: rounded to nanoseconds, halves
    to even; 0 if negative or NaN, at most 10⁹ s. *)

val of_nanoseconds : int64 -> instant
(** That long after the instant before. *)

val later : int64 -> instant -> int64
(** A local time in nanoseconds, one instant later; it stops at 2⁶³ - 1 ns,
    which are 292 years. *)

val seconds : int64 -> float
