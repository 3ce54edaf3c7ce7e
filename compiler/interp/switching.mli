(** Switches, as the language reference has them (section 6).

    A new signal function starts at the instant of the event, on the input of that instant, with its
    own first instant; the one before is forgotten. *)

val switch : Thunk.nesting -> delayed:bool -> Value.thunk -> Value.thunk -> Value.instance
(** Of the signal function before the event and the continuation. [delayed]: [dSwitch], whose output
    does not depend on the event of the instant. *)

val recurring : Thunk.nesting -> delayed:bool -> Value.thunk -> Value.instance
(** [rSwitch] and [drSwitch]. *)

val on_event : Thunk.nesting -> Value.thunk -> Value.instance
(** [onEvent]: its body has its instants where the event occurs. *)

val initially : Thunk.nesting -> Value.thunk -> Value.instance
