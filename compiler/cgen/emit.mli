(** The C files of a program, as strings. *)

type t = {
  header : string;  (** NAME.h *)
  source : string;  (** NAME.c *)
  host_table : string option;
      (** NAME_host.c, which only hosts need; [None] if the program's input or output contains a
          foreign type, which hosts do not support *)
  robot : string option;  (** the name of the program's robot, if it has one *)
  node : Node_table.t option;  (** the topics, if the program is a ROS 2 node with its own topics *)
  robot_header : (string * string) option;
      (** the header for the user's own robot, which [header] includes: its name and its text.
          {!program} returns [None] here; {!Interface_header} generates the header from the robot's
          module *)
  cameras : string list;  (** labels of the cameras that the program reads *)
  simulated : string list;  (** sensors that only the simulator has, such as "the lidar `lidar`" *)
  foreign : foreign;
}

and foreign = {
  calls : string list;  (** the C functions named by [foreign] declarations *)
  headers : Flow.Ir.header list;  (** the headers named by [foreign include] declarations *)
}
(** The user's C code that a build needs. *)

val program :
  ?own:Robot.t ->
  ?units:Units.t ->
  ?named:Named_constants.t ->
  ?batch:bool ->
  ?banner:string list ->
  ?node:Node_table.t ->
  Step.Ir.program ->
  t
(** [own]: the user's own robot, if the program is for one. [units]: for the comments of members;
    {!Units.none} by default. [named]: the constants that keep their names; {!Named_constants.none}
    by default. [batch]: adds the function that runs many steps ({!Batch}). [banner]: lines for the
    comment at the top of the header and the source. [node]: the topics of a node. *)

val print : Format.formatter -> t -> unit
(** Prints the header, then the source. *)
