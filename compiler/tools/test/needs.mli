(** Requirements of tests that only the command line can supply: the module of a user-defined robot,
    and C files. frobc does not use C files automatically, because they may contain somebody else's
    code. *)

type t = {
  what : string;  (** description, such as [the robot Moth and its body in C] *)
  command : string;  (** the command that runs the tests *)
}

val of_file : Session.t -> string -> Checks.t list -> t option
(** Finds the files that these tests need, that the command line does not name, and that are next to
    the program: a robot's module and the C files with its body, C files that define functions that
    the program calls, and headers that it includes. Any other missing file is reported when the
    tests run. *)

val library : string -> t option
(** [library reason]: the missing library, if [reason] says that a test could not run because a
    library is not installed. *)
