(** The header with a robot's input and output structs, from the types that its module declares. *)

val text : Robot.t -> Step.Ir.program -> string
(** The program's input and output are the robot's: that of any signal function from the one to the
    other. *)
