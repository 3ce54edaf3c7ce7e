(** Bags, in which ROS 2 records messages. A program that runs as a ROS 2 node publishes its
    instants, so a bag can contain a recording of the program. *)

val recording : program:string -> string -> (string, string) result
(** Extracts the program's recording from a bag to a temporary file and returns that file's path. If
    the given path is not a bag, returns it unchanged. [program] is the file of the program. *)

val for_its_robot : Common_options.t -> string option -> Common_options.t
(** The options for replaying a program from this recording. If the recording is a bag, the robot is
    [ros], unless the user chose another one. *)
