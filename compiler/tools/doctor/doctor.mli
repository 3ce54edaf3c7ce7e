(** [frobc doctor]: looks at everything that a command may need, and says what to type where
    something is missing. *)

val run : unit -> int
(** The exit status is 1 if frobc itself does not work on this computer. Something missing that only
    some commands need does not change it. *)
