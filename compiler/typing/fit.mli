(** Whether a program that leaves its robot open runs on a robot: its type is
    [Program i o] with class constraints, which the robot's types must meet. *)

type robot = { input : Ir.Global.t; output : Ir.Global.t }
(** The types of what it senses and of what it can do; without parameters. *)

type lack = {
  class_ : Ir.Global.t;
  of_ : Ir.Global.t;  (** the type without an instance of it *)
  need : Ir.need;
}

val is_open : Ir.definition -> bool
(** A program whose input or output its type does not tell. *)

val lacks : Ir.program -> Ir.definition -> robot -> lack list option
(** What the robot lacks of all that an open program asks for; [None] if the
    program is not for such a robot, whatever its capabilities. *)
