(** [frobc new]: a folder with a program that runs, checks, is formatted and passes its trials. *)

val run : string -> int
(** [run "robots/rover"] makes the folder, and those above it; the program is [rover.frob]. The
    files are those of [template/], in which [@NAME@] is the project's name and [@FILE@] the
    program's. Gives the exit status. What is there already is never touched: an error then. *)
