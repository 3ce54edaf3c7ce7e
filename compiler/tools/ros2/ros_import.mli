(** [frobc ros2 import]: writes a module that declares a record for a ROS 2 message type. *)

val import : most:int -> output:string option -> string -> int
(** Writes the module for the message type [PACKAGE/Type], which is looked up in the folders of
    [AMENT_PREFIX_PATH]. [most]: the maximum length of sequences that are unbounded in ROS. Returns
    the exit status. *)
