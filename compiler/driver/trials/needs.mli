(** What tests need that only the command line gives: C files, as what somebody else wrote must not
    reach C by itself, and the module of a robot of one's own. *)

type t = {
  what : string;  (** in words: [the robot Moth and its body in C] *)
  command : string;  (** that runs them *)
}

val of_file : Checking.t -> string -> Checks.t list -> t option
(** Of tests of the program in a file, if they need what is not given and lies beside the program: a
    robot's module and the C that has its body, C files that mention what the program calls. What is
    nowhere is told when they run. *)
