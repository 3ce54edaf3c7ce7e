(** The files of a program, of which one is named on the command line. *)

val files : Resolve.Files.t
(** Those on the disk; the trees of the library's are in the compiler. *)

val modules : library:string -> string -> string list * string list
(** The files of the modules of a program: its own, that of the program first, and those of the
    library. *)

val check : string -> (unit, string) result
(** [Ok] if it is there, can be read, and is not, by its name's ending or by its bytes, something
    else, such as a world or a recording. The error is a text for the user, which says what takes
    such a file. *)

val all_exist : string list -> (unit, string) result
(** Whether the files named on the command line are there. *)
