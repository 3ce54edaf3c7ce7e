(** Finds the files of a program, one of which is named on the command line. *)

val files : Resolve.Files.t
(** Reads files from the disk. The syntax trees of library modules are built into the compiler. *)

val modules : library:string -> string -> string list * string list
(** The files of the program's own modules, the main one first, and of the library modules it uses.
*)

val check : string -> (unit, string) result
(** Checks that the file exists, can be read, and does not have the extension or the content of
    another kind of file, such as a world or a recording. The error is a message for the user; for
    another kind of file, it names the command that uses such files. *)

val with_tests : string list -> string list
(** Files from the command line, without duplicates, each followed by its test file if it has one
    ({!Resolve.Test_file}). *)

val all_exist : string list -> (unit, string) result
(** Checks that the files named on the command line exist. *)
