(** Generates NAME_host.c, which contains the table of <frob/program.h>. Hosts use this table to
    read and write the values of any program. *)

val robot : ?own:Robot.t -> Step.Ir.program -> Robot.t option
(** The robot whose input or output type the program uses. [own]: the user's own robot, if the
    program is for one. *)

val text : ?own:Robot.t -> ?node:Node_table.t -> Step.Ir.program -> Of_step.t -> string
