(** Time: counted in whole nanoseconds (language reference, section 3). *)

type instant = int64
(** The nanoseconds since the instant before; 0 at a signal function's first. *)

val first : instant

val after : Basis.Real.t -> float -> instant
(** An instant that many seconds, a number of this precision, after another: rounded to nanoseconds,
    halves to even; 0 if negative or NaN, at most 10⁹ s. Of a single the fraction of a second is
    multiplied by 10⁹ as a single too, which makes 100,000,000 ns of the single nearest to 0.1, that
    is 1.5 ns more. *)

val later : int64 -> instant -> int64
(** A local time in nanoseconds, one instant later; it stops at 2⁶³ - 1 ns, which are 292 years. *)

val seconds : Basis.Real.t -> int64 -> float
(** Of nanoseconds: these in the precision of the program, divided by 10⁹. *)
