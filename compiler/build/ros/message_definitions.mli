(** Finds the definitions of message types: in the packages of the sourced ROS 2, and those of
    common packages also without ROS 2. *)

val prefixes : unit -> string list
(** The folders of the sourced ROS 2. *)

type found =
  | Defined of Message_file.t
  | No_message of string list  (** the package does not have it; its messages *)
  | No_package
  | Unreadable of string  (** the message names the file *)

val in_ros2 : package:string -> name:string -> found
(** Only searches the sourced ROS 2. *)

val find : package:string -> name:string -> found
(** Searches the sourced ROS 2 first, then the common packages. *)
