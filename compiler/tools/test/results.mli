(** Prints the results of tests for the terminal, other tools, and CI servers. *)

val failures : Outcome.t -> Outcome.run list
val has_failed : Outcome.t -> bool

val decided : Outcome.t -> int option
(** The number of runs that it took to decide whether the property holds in the required proportion
    of runs; [None] if this is undecided, or if the test requires no proportion. *)

val print : Outcome.t -> unit
(** Prints one line on standard output, and details if the test has failed. *)

val print_skipped : Outcome.skipped -> unit
val print_total : Outcome.t list -> skipped:int -> unit

val json : Outcome.t -> string
(** One JSON object on a single line. *)

val skipped_json : Outcome.skipped -> string

val junit : Outcome.t list -> Outcome.skipped list -> string
(** A report in JUnit's XML format, for CI servers. *)
