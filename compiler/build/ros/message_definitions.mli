(** Finds the definitions of message types in the packages of the sourced ROS 2 installation. The
    definitions of common packages are found even without ROS 2. *)

val prefixes : unit -> string list
(** The installation prefixes of the sourced ROS 2. *)

type found =
  | Defined of Message_file.t
  | No_message of string list  (** the package has no such message; these are its messages *)
  | No_package
  | Unreadable of string  (** the file cannot be parsed; the error message names it *)

val in_ros2 : package:string -> name:string -> found
(** Searches only the sourced ROS 2 installation. *)

val find : package:string -> name:string -> found
(** Searches the sourced ROS 2 installation first, then the common packages. *)
