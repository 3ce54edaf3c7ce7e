(** [frobc falsify]: searches for a run that violates an assertion.

    The search is written in Python, which has the libraries for it and can keep all instants of a
    run in memory. The Python package compiles the program by calling this frobc with
    [--asserts=margin], loads it, and runs it. This module only finds and starts the package. *)

val run : Common_options.t -> entry:string -> sources:string list -> Search.t -> string -> int
(** Replaces this process with the search, which exits with {!Exit_status.rejected} if it finds a
    violation. *)
