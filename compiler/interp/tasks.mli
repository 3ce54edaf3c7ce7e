(** Tasks: activities that end, one after the other (language reference, section 7). *)

val make : Value.thunk -> Value.t
(** [mkTask]: ends at its signal function's event. *)

val until_right : Value.thunk -> Value.t
(** Ends at its signal function's first [Right]. *)

val run : Thunk.nesting -> Value.thunk -> Value.instance
(** [runTask]. *)
