(** [frobc test]: runs the tests and trials that are written in programs. *)

val run : General.t -> sources:string list -> Checking.options -> string list -> int
(** Of files, and of all files with tests in folders. The outcome does not depend on [jobs]. Exit
    status 1 if one fails. *)
