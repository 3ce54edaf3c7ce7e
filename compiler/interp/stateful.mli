(** The primitive signal functions: all that has state (language reference,
    section 3). That the length of the first step is 0 makes the integral 0
    there, and the derivative its last value, initially 0. *)

val delay : Value.thunk -> Value.instance
(** From the initial value. *)

val time : unit -> Value.instance
val integral : unit -> Value.instance
val derivative : Thunk.nesting -> Value.instance
