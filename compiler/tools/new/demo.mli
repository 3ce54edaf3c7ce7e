(** [frobc demo]: copies an example to a new folder and runs it in its world. *)

val run : Simulating.run -> int
(** The folder is [frob-demo]. If it exists, the demo uses its files unchanged, because the user may
    have edited them. Ignores any world in the run's options. *)
