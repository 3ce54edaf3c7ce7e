(** Parses the hosts' output about the runs of tests. *)

val of_trace : string -> Outcome.run
(** The result of a test without a robot, from the trace of its judge, which includes the verdicts
    of assertions. *)

val of_trial : string -> Outcome.run list
(** The results of a trial, from the output of [frob-sim --judge]: one line for each seed. *)

val around : string -> string list
(** Summarizes the end of a recording that stops at a failure: the program's output in the last two
    instants, with a line for each column that has a value. *)
