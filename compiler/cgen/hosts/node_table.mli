(** The topics of a ROS 2 node, for its host. *)

type topic = {
  field : string;  (** of the program's input or output *)
  name : string;  (** before remapping: ["cmd_vel"] *)
  type_ : string;  (** of its messages: ["geometry_msgs/msg/Twist"] *)
  is_counted : bool;  (** the field is an event of a [Counted] *)
  is_command : bool;  (** a message of zeros stops what it controls *)
}

type t = { rate : float; inputs : topic list; outputs : topic list }

val write : Buffer.t -> t option -> string
(** Writes the tables, and returns the C expression for the program's field [node]. *)
