(** The machines for which executables that drive robots can be built. *)

type t

val names : string list
val of_name : string -> t option

val meaning : t -> string
(** A short description for the user. *)

val own_driver : name:string -> Cgen.Robot.t option -> string * string
(** The name and content of the file that passes the user-defined driver to the host. For the robot
    [rover], the driver is [const struct frob_driver frob_rover_driver]. *)

val linked :
  ?own:Cgen.Robot.t -> t -> real:Basis.Real.t -> Resources.t -> name:string -> Built.linked
(** [own]: the user-defined robot, whose driver is among the user's C files. *)

val ros2 : Ros2.t -> Resources.t -> name:string -> Built.linked
(** What to link into a ROS 2 node for this machine. *)

val simulated_ros2 : Ros2.t -> Resources.t -> (string, string) result
(** Compiles the ROS 2 node of a simulated robot, and returns its path. *)

val size_tool : t -> string option
(** The program that prints the memory use of an executable, for targets where this matters. *)

val state_of : string -> string * string
(** The name and content of a file that reserves memory for a program's state, for hosts without a
    heap. *)
