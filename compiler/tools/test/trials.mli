(** [frobc test]: runs the tests and trials in programs. *)

val run : Common_options.t -> sources:string list -> Session.options -> string list -> int
(** Runs the tests of files, and of all files with tests in folders. The outcome does not depend on
    [jobs]. The exit status is 1 if a test fails. *)
