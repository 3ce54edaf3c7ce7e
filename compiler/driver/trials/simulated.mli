(** Trials: the program in the simulator, many seeds at a time. *)

val world_of : Checking.t -> string -> string -> (string, string) result
(** [world_of context file name]: the path of the world, beside the program or of those that come
    with frobc. *)

val run : Checking.t -> string -> Checks.t -> Checks.trial -> Outcome.t
(** Of the program in a file. Of a trial that fails the run that fails first is shrunk: to the
    disturbances of the world that it needs to fail in the same way. *)
