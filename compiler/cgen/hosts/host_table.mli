(** NAME_host.c: the table of <frob/program.h>. Hosts, which know nothing about the program, use it
    to read and write the program's values. *)

val robot : ?own:Robot.t -> Step.Ir.program -> Robot.t option
(** The robot whose input or output the program has. [own]: the robot of the user's own, if the
    program is for one. *)

val text : ?own:Robot.t -> Step.Ir.program -> Of_step.t -> string
