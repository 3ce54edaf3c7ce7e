(** Runs trials: simulates the program with many seeds. *)

val world_of : Session.t -> string -> string -> (string, string) result
(** [world_of context file name] returns the path of the world [name], which is either next to the
    program or one of those that come with frobc. *)

val run : Session.t -> string -> Checks.t -> Checks.trial -> Outcome.t
(** Runs a trial of the program in a file. If it fails, repeats the run that failed earliest, and
    saves its recording and picture. Also saves a simpler run, with only those of the world's
    disturbances that are needed to reproduce the failure, and reports that run separately. *)
