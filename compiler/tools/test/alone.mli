(** Runs tests without a robot. Such a test is a signal function that has no input and runs for a
    given time. *)

val run : Session.t -> string -> Checks.t -> Outcome.t
(** Runs a test of the program in this file. *)
