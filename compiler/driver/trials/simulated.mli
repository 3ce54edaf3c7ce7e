(** Trials: the program in the simulator, many seeds at a time. *)

val run : Checking.t -> string -> Checks.t -> Checks.trial -> Outcome.t
(** Of the program in a file. Of a trial that fails the run that fails first is shrunk: to the
    disturbances of the world that it needs to fail in the same way. *)
