(** The primitive signal functions: all that has state (language reference, section 3). That the
    length of the first step is 0 makes the integral 0 there, and the derivative its last value,
    initially 0. *)

val delay : Value.thunk -> Value.instance
(** From the initial value. *)

val time : Basis.Real.t -> Value.instance
val step_time : Basis.Real.t -> Value.instance

val time_since : Basis.Real.t -> Thunk.nesting -> Value.instance
(** Since the input was last True, or else since the start; 0 where it is. *)

val ticks : Thunk.nesting -> Value.thunk -> Value.instance
(** Of a number of nanoseconds, a fraction of it being dropped: is a multiple of it later than the
    instant before, and not later than this one? Always if it is less than 1, never if it is NaN. *)

val integral : Basis.Real.t -> Value.instance
val derivative : Basis.Real.t -> Thunk.nesting -> Value.instance
