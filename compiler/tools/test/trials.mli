(** [frobc test]: runs the tests and trials in programs. *)

val run : Common_options.t -> sources:string list -> Session.options -> string list -> int
(** Runs the tests in these files and folders. The outcome does not depend on [jobs]. The exit
    status is 1 if a test fails. *)
