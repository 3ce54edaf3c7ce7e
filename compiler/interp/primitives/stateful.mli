(** The primitive signal functions, which contain all the state of a program (language reference,
    section 3). In the first step, whose length is 0, the integral is 0, and the derivative has its
    initial value, which is 0 as well. *)

val delay : Value.thunk -> Value.instance
(** The argument is the signal's initial value. *)

val time : Basis.Real.t -> Value.instance
val step_time : Basis.Real.t -> Value.instance

val time_since : Basis.Real.t -> Thunk.nesting -> Value.instance
(** Time since the input was last True, or since the start if it never was; 0 while it is True. *)

val ticks : Thunk.nesting -> Value.thunk -> Value.instance
(** The period is a number of nanoseconds; its fraction is dropped. The output is True if a multiple
    of the period is later than the previous instant but not later than this one. It is always True
    for a period below 1, and never for NaN. *)

val integral : Basis.Real.t -> Value.instance
val derivative : Basis.Real.t -> Thunk.nesting -> Value.instance
