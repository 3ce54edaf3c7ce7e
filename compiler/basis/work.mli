(** Limits the work of a stage.

    The limit is in steps rather than seconds, so that every machine rejects the same programs. Each
    stage decides what it counts as a step, for example, evaluating an expression or visiting a part
    of a type. A step takes tens of nanoseconds. Only loops that can run for a long time on a short
    program need to count their steps.

    The counter is the compiler's only mutable global. {!within} restores it however its function
    ends, so compilations do not affect each other. *)

exception Used_up
(** Raised by {!step} and {!steps}; caught by {!within}. Other code must not catch it. *)

val step : unit -> unit
(** Counts one step towards the limit of the innermost {!within}. *)

val steps : int -> unit
(** Counts several steps. Call it before performing them. *)

val within : int -> (unit -> 'a) -> 'a option
(** Calls the function with this limit, or with the remaining steps of the enclosing {!within} if
    those are fewer; [None] if the function exceeds the limit. Its steps also count towards the
    limit of the enclosing {!within}. *)

val left : unit -> int
(** The remaining steps of the innermost {!within}. *)
