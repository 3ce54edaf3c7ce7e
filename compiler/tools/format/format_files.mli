(** [frobc format]: formats programs with {!Formatting.Formatter}. *)

val run : check:bool -> string list -> int
(** Rewrites the files that change; [-] reads standard input and writes standard output. If [check]
    is true, writes nothing, but lists the files that would change, each with the first line that
    would change. Returns the exit status. *)
