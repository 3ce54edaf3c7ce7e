(** [frobc ros2 import]: writes a module with the record of a message type of ROS 2. *)

val import : most:int -> output:string option -> string -> int
(** Writes the module for the message type [PACKAGE/Type], which is found by [AMENT_PREFIX_PATH].
    [most]: the maximum length of sequences that are unbounded in ROS. Returns the exit status. *)
