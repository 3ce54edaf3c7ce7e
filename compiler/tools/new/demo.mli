(** [frobc demo]: copies an example to a new folder and drives it through its world. *)

val run : Simulating.run -> int
(** The folder is [frob-demo]. If it exists, its files are used as they are, because the user may
    have changed them. Ignores the world of the run. *)
