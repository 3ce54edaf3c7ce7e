(** The topics of a ROS 2 node, for its host. *)

type topic = {
  field : string;  (** the name of the field in the program's input or output *)
  name : string;  (** before remapping: ["cmd_vel"] *)
  type_ : string;  (** the type of its messages: ["geometry_msgs/msg/Twist"] *)
  is_counted : bool;  (** whether the type of the field is [Event (Counted m)] *)
  is_command : bool;  (** whether an all-zero message stops the controlled device *)
}

type texts = {
  module_ : string;
  type_ : string;
  texts : string list;  (** one for each constructor, in order *)
}
(** An enumeration whose constructors represent strings in messages. *)

type enumeration = {
  constructors : string;  (** the name of the C table *)
  module_ : string;
  type_ : string;
}
(** A type in the input or output whose constructors have no fields. *)

type t = { rate : float; inputs : topic list; outputs : topic list; texts : texts list }

val write : Buffer.t -> enumerations:enumeration list -> t option -> string
(** Writes the tables, and returns the C expression for the program's field [node]. *)
