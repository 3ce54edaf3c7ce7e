(** Whether a program that leaves its robot open runs on a robot: its type is [Program i o], or
    [SF i o], with class constraints, which the robot's types must meet. *)

type robot = { input : Ir.Global.t; output : Ir.Global.t }
(** The types of what it senses and of what it can do; without parameters. *)

type lack = {
  class_ : Ir.Global.t;
  of_ : Ir.Global.t;  (** the type without an instance of it *)
  need : Ir.need;
}

type openness =
  | Closed
  | Open_signal_function  (** a signal function whose types are open, for a robot or not *)
  | Open_program

val openness : Ir.definition -> openness

val lacks : Ir.program -> Ir.definition -> others:Ir.Global.t list -> robot -> lack list option
(** What the robot lacks of all that an open program or signal function asks for; [None] if it is
    not for such a robot, whatever its capabilities. A signal function may have one end that is of
    no robot's type at all, that is, of none of [others]. *)
