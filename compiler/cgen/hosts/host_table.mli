(** NAME_host.c: the table of <frob/program.h>. Hosts, which are written without knowledge of the
    program, use it to read and write the program's values. *)

val robot : ?own:Robot.t -> Step.Ir.program -> Robot.t option
(** The robot whose input or output type the program has. [own]: the user's own robot, if the
    program is for one. *)

val text : ?own:Robot.t -> ?node:Node_table.t -> Step.Ir.program -> Of_step.t -> string
