(** NAME_host.c: the table of <frob/program.h>, by which a host that does not
    know the program reads and writes its values. *)

val text : ?own:Robot.t -> Machine.Ir.program -> Of_machine.t -> string
