(** The header with a robot's input and output structs, generated from the types that its module
    declares. *)

val text : Robot.t -> Step.Ir.program -> string
(** The text of the header. The program can be any signal function from the robot's input type to
    its output type. *)
