(** The definitions of common message types of ROS 2, from the file [known_messages.msg]. *)

val text : string
(** Each definition begins with a line such as [MSG: geometry_msgs/Twist]. Comments and constants
    are omitted. *)
