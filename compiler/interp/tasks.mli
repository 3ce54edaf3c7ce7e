(** Tasks: activities that run one after another, each until it ends (language reference, section
    7). *)

val make : Value.thunk -> Value.t
(** [mkTask]: a task that ends when the event of its signal function occurs. *)

val until_right : Value.thunk -> Value.t
(** A task that ends at the first [Right] of its signal function. *)

val run : Thunk.nesting -> Value.thunk -> Value.instance
(** [runTask]. *)
