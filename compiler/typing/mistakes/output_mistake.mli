(** What is said where a function that sets a robot's output, such as [setVelTR v omega], stands for
    the output that [roMake] makes of it. *)

val hint : subject:Resolve.Ir.expr option -> expected:Type.t -> found:Type.t -> string option
(** If it is that: where an output or a whole program is expected. *)

val hint_without_instance : Type.t -> string option
(** Likewise of a type that is to be an output, and is no instance of [RobotOutput]. *)
