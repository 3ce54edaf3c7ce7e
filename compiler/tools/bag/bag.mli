(** Bags: the recordings of messages that ROS 2 writes. A program that runs as a ROS 2 node
    publishes its instants, so a bag can contain a recording of the program. *)

val recording : program:string -> string -> (string, string) result
(** Returns the path of the program's recording in the bag, which is extracted to a temporary file.
    If the path is not a bag, returns it unchanged. [program] is the file of the program. *)

val for_its_robot : Common_options.t -> string option -> Common_options.t
(** The options for replaying a program from this recording. If the recording is a bag, the robot is
    [ros], unless the user chose another one. *)
