(** A function that sets a robot's output, such as [setVelTR v omega], used in place of the output
    that [roMake] creates from it. *)

open Typing

val not_made : Shape_fact.rule
(** Applies if an output or a whole program is expected. *)

val speeds : Shape_fact.rule
(** A speed and a turn rate, as a pair, in place of a robot's output. *)

val task_of_a_program : Shape_fact.rule
(** A task as the output of the signal function that a robot runs. *)

val of_sleeping : Wording.t -> subject:Resolve.Ir.expr option -> Type.t -> Basis.Diagnostic.t option
(** The message for [sleepT 2[s] (setVelTR v omega)], or for [sleepT] with its arguments swapped, in
    a task whose signature allows any output. The type is the one found in place of that output. *)

val statement : Shape_fact.rule
(** Applies if the function is a statement in a [do]. *)

val hint_without_instance : Type.t -> string option
(** The hint for a type without an instance of [RobotOutput], where an output is required. *)

val hint_for_a_twist : Wording.t -> Type.t -> string option
(** The hint for a [Twist] of ROS in place of a robot's output. *)

val twist : Shape_fact.rule
(** A [Twist] of ROS in place of a robot's output. *)
