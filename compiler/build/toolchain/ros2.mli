(** Finds the installation of ROS 2 with which the executables of [frobc run --ros2] are compiled
    and linked. The environment variable [AMENT_PREFIX_PATH] lists the folders that contain its
    packages. The setup scripts of ROS 2, which users source, set this variable. *)

type t = {
  options : string list;  (** options for the C compiler, with the folders of the headers *)
  libraries : string list;  (** libraries to link with, in this order *)
}

val find : unit -> (t, string) result
(** The error says which script the user should source, or what to install. *)

val untried : unit -> string option
(** A warning for the user if frobc is not tested with the installed distribution. *)
