(** Determines whether a robot-independent program can run on a given robot.

    Such a program has the type [Program i o] or [SF i o], with class constraints that the robot's
    types must satisfy. *)

type robot = { input : Ir.Global.t; output : Ir.Global.t }
(** The types of its sensor input and its output. They have no parameters. *)

type lack = {
  class_ : Ir.Global.t;
  of_ : Ir.Global.t;  (** the type that has no instance of the class *)
  need : Ir.need;
}

type openness =
  | Closed
  | Open_signal_function
      (** a signal function with type variables, whether or not it is for a robot *)
  | Open_program

val openness : Ir.definition -> openness

val lacks : Ir.program -> Ir.definition -> others:Ir.Global.t list -> robot -> lack list option
(** For an open program or signal function, the constraints that the robot does not satisfy. [None]
    if the types rule out this robot, whatever its capabilities. [others]: the input and output
    types of all robots. In a signal function, either the input or the output (not both) may also
    have a type that is not among these. *)
