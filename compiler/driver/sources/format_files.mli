(** [frobc format]: programs as {!Formatting.Formatter} writes them. *)

val run : check:bool -> string list -> int
(** Writes these files anew where they change; [-] is from standard input to standard output. With
    [check] nothing is written, but which files would change, each with its first line that would.
    Gives the exit status. *)
