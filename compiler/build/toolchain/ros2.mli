(** An installation of ROS 2, with which the executables of [frobc run --ros2] are compiled and
    linked.

    frobc finds it through the environment variable [AMENT_PREFIX_PATH], which lists folders with
    packages. The setup scripts of ROS 2, which users source, set this variable. *)

type t = {
  options : string list;  (** options for the C compiler, with the folders of the headers *)
  libraries : string list;  (** libraries to link with, in this order *)
}

val find : unit -> (t, string) result
(** The error says which script the user should source, or what to install. *)

val untried : unit -> string option
(** A warning for the user if the installation is not of one of these distributions. *)
