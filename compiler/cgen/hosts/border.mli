(** Between a program of single precision and its hosts.

    Robots' structs are of doubles whatever a program computes with, as their drivers and the
    simulator are; a program of single precision has structs of its own. The table for hosts
    describes the robot's, and its step converts: an input's doubles are rounded to floats, an
    output's floats are doubles already. Time too is converted there, to whole nanoseconds. In
    double precision both sides are the same, and nothing is converted. *)

type side = {
  own : Interface.t;  (** of the program *)
  host : Interface.t;
  robot : Robot.t option;  (** whose struct the host's is, if that is not the program's *)
}
(** The input or the output. *)

val input : ?own_robot:Robot.t -> Step.Ir.program -> Interface.t -> side
(** [own_robot]: the user's own, if the program is for one. *)

val output : ?own_robot:Robot.t -> Step.Ir.program -> Interface.t -> side

val is_own : side -> Interface.step list -> bool
(** Does this lead, in the host's struct, to what is beside a robot's command: what the program has
    ended with, and its probes? Those are the program's own in both structs. *)

val includes : side list -> string
(** Of the robots' headers, as lines. *)

val definitions : Step.Ir.program -> side -> string
(** Of the host's output where it is a robot's and something beside it. *)

val passed : Param_struct.t option -> string * string
(** How a function of the table that is given [params] ignores them, and how it passes them on after
    the state. *)

val step :
  params:Param_struct.t option ->
  Step.Ir.program ->
  Sum_type.t array ->
  name:string ->
  input:side ->
  output:side ->
  string
(** The table's step, and what it needs: C functions, as text. In single precision also
    [arithmetic], for the table. *)
