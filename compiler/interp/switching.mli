(** Switches (language reference, section 6).

    A new signal function takes its first step in the instant of the event, on the input of that
    instant. The old one is discarded. *)

val switch : Thunk.nesting -> delayed:bool -> Value.thunk -> Value.thunk -> Value.instance
(** Takes the signal function to run before the event, and the continuation. [delayed] selects
    [dSwitch], whose output does not depend on whether the event occurs in the same instant. *)

val recurring : Thunk.nesting -> delayed:bool -> Value.thunk -> Value.instance
(** [rSwitch] and [drSwitch]. *)

val on_event : Thunk.nesting -> Value.thunk -> Value.instance
(** [onEvent]: its body takes a step only when the event occurs. *)

val initially : Thunk.nesting -> Value.thunk -> Value.instance
