(** Converts between a single-precision program and its hosts.

    The structs of robots contain doubles, regardless of the program's precision, because drivers
    and the simulator use doubles. A single-precision program has its own structs. The table for
    hosts describes the robot's structs, and the table's step function converts between the two: it
    rounds the input's doubles to floats, and widens the output's floats to doubles. It also
    converts time to whole nanoseconds. In double precision, both sides use the same structs, and
    nothing is converted. *)

type side = {
  own : Interface.t;  (** the program's struct *)
  host : Interface.t;
  robot : Robot.t option;
      (** the robot that the host's struct belongs to; [None] if it is the program's struct *)
}
(** The structs of the input, or of the output. *)

val input : ?own_robot:Robot.t -> Step.Ir.program -> Interface.t -> side
(** [own_robot]: the user's own robot, if the program is for one. *)

val output : ?own_robot:Robot.t -> Step.Ir.program -> Interface.t -> side

val is_own : side -> Interface.step list -> bool
(** Whether this path leads to a part of the host's struct that belongs to the program rather than
    the robot: the console, the result or the probes. Such a part has the program's own type in both
    structs. *)

val includes : side list -> string
(** The lines that include the robots' headers. *)

val definitions : Step.Ir.program -> side -> string
(** The definition of the host's struct; empty unless that struct contains a robot's struct and
    other parts. *)

val passed : Param_struct.t option -> string * string
(** How a function in the table treats its argument [params]: the statement that marks the argument
    as unused, and the text that passes it on after the state. One of the two is empty. *)

val step :
  params:Param_struct.t option ->
  Step.Ir.program ->
  Sum_type.t array ->
  name:string ->
  input:side ->
  output:side ->
  string
(** The table's step function and the C functions it needs, as text. In single precision, this text
    includes the function [arithmetic], which the table refers to. *)
