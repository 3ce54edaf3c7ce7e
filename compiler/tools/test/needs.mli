(** Requirements of tests that only the command line can supply: C files, because code from somebody
    else must not reach the C compiler automatically, and the module of a user-defined robot. *)

type t = {
  what : string;  (** description, such as [the robot Moth and its body in C] *)
  command : string;  (** the command that runs the tests *)
}

val of_file : Session.t -> string -> Checks.t list -> t option
(** The missing requirements of these tests, if the files for them are next to the program: a
    robot's module and the C files with its body, C files that define functions that the program
    calls, and headers that it includes. Any other missing file is reported when the tests run. *)

val library : string -> t option
(** [library reason]: the missing library, if [reason] says that a test could not run because a
    library is not installed. *)
