(** Tests without a robot: a signal function without input, which runs for a certain time. *)

val run : Session.t -> string -> Checks.t -> Outcome.t
(** Runs a test of the program in this file. *)
