(** A function that sets a robot's output, such as [setVelTR v omega], used in place of the output
    that [roMake] creates from it. *)

val not_made : Shape_fact.rule
(** Applies if an output or a whole program is expected. *)

val statement : Shape_fact.rule
(** Applies if the function is a statement of a [do]. *)

val hint_without_instance : Type.t -> string option
(** The hint for a type without an instance of [RobotOutput], where an output is required. *)
