(** Runs trials: simulates the program with many seeds. *)

val world_of : Session.t -> string -> string -> (string, string) result
(** [world_of context file name] is the path of the world, which is next to the program or comes
    with frobc. *)

val run : Session.t -> string -> Checks.t -> Checks.trial -> Outcome.t
(** Runs a trial of the program in a file. If it fails, repeats the run that failed earliest, and
    saves its recording and picture. Also saves a simpler run, with only those disturbances of the
    world that are needed for the failure, and reports that run separately. *)
