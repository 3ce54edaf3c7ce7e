(** [frobc format]: formats programs with {!Formatting.Formatter}. *)

val run : check:bool -> string list -> int
(** Rewrites the files whose formatting changes. For [-], formats standard input and writes the
    result to standard output. If [check] is true, only lists the files that would change, each with
    the first line that would change. Returns the exit status. *)
