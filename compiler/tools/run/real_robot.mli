(** Commands for robots on a serial line or controlled through ROS 2. They simulate such a robot, or
    run or build a program for a real one. Like {!Commands}, each returns the exit status. *)

type serve = {
  world : string option;
  log : string option;  (** file in which received commands are logged *)
  link : string option;  (** symbolic link to create for the device *)
  stamped : bool;  (** whether ROS 2 commands have the type [TwistStamped] *)
  ros_arguments : string list;  (** arguments for ROS 2 *)
  host : string list;  (** additional arguments for the server *)
}

val serve : robot:string option -> sources:string list -> serve -> int
(** Replaces this process with the simulated robot. [sources] are the C files of a user-defined
    robot. *)

type way =
  | Device of string  (** a serial device, or [tcp:HOST:PORT] *)
  | Ros2 of { lifecycle : bool; arguments : string list }
      (** as a ROS 2 node: whether it is managed, and the arguments for ROS 2 *)

type run = {
  way : way;  (** how the program reaches its robot *)
  record : string option;
  look : Viewing.look option;  (** how the run is shown live *)
  host : string list;  (** additional arguments for the program that drives the robot *)
}

val run : Common_options.t -> entry:string -> sources:string list -> run -> string -> int
(** Replaces this process with the program that drives the robot. *)

val build :
  Common_options.t ->
  entry:string ->
  sources:string list ->
  target:string ->
  output:string option ->
  string ->
  int
(** Builds the program that drives the robot for a {!Target}. [sources] are the user's own C files.
*)

val with_markers : Common_options.t -> Common_options.t
(** Options with which the ROS 2 node also publishes the program's drawing, if any, as markers. *)

val build_node :
  Common_options.t -> entry:string -> sources:string list -> output:string option -> string -> int
(** Builds the program as a ROS 2 node, for this machine. *)

val library :
  Common_options.t -> entry:string -> sources:string list -> output:string option -> string -> int
(** Builds the program, whether or not it is for a robot, as a shared object for hosts on this
    machine. The hosts use its table ([frob/program.h]) and its function that takes many steps. *)
