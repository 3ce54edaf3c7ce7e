(** What hosts wrote of the runs of tests. *)

val of_trace : string -> Outcome.run
(** Of a test by itself: the trace of its judge, with the verdicts on assertions. *)

val of_trial : string -> Outcome.run list
(** Of a trial: a line for each seed, as [frob-sim --judge] writes it. *)

val around : string -> string list
(** Of the text of a recording that ends where something failed: what the program gave at the last
    two instants, a line for each column that has a value. *)
