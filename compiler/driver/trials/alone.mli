(** Tests by themselves: a signal function without input, for a time. *)

val run : Checking.t -> string -> Checks.t -> Outcome.t
(** Of the program in a file. *)
