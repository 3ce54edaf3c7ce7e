(** The header with a robot's input and output structs, generated from the types that its module
    declares. *)

val text : Robot.t -> Step.Ir.program -> string
(** The program must have the robot's input and output types. It may be any signal function from one
    to the other. *)
