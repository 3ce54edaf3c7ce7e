(** NAME_host.c: the table of <frob/program.h>, by which a host that does not know the program reads
    and writes its values. *)

val robot : ?own:Robot.t -> Step.Ir.program -> Robot.t option
(** The robot whose input or output the program's is; [own]: the user's own, if the program is for
    one. *)

val text : ?own:Robot.t -> Step.Ir.program -> Of_step.t -> string
