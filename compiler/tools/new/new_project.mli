(** [frobc new]: creates a folder with a program that runs, has no warnings, is formatted, and
    passes its trials. *)

val run : string -> int
(** [run "robots/rover"] creates the folder and its parents; the program is [rover.frob]. The files
    come from [template/], in which [@NAME@] is replaced by the project's name, and [@FILE@] by the
    program's file name. Returns the exit status. Existing files are never changed: if the folder
    contains one of them, that is an error. *)
