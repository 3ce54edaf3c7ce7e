(** The file of a program, as it is named on the command line. *)

val check : string -> (unit, string) result
(** [Ok] if it is there, can be read, and is not, by its name's ending or by its bytes, something
    else, such as a world or a recording. The error is a text for the user, which says what
    takes such a file. *)
