(** An installation of ROS 2, which executables of [frobc run --ros2] are compiled and linked with.

    A user makes it known by the environment variable [AMENT_PREFIX_PATH], which the scripts that
    users source set. It lists folders with packages. *)

type t = {
  options : string list;  (** for the C compiler, with the folders of the headers *)
  libraries : string list;  (** to link with, in this order *)
}

val find : unit -> (t, string) result
(** The error is a text for the user: what to source or to install. *)

val tried : (string * string) list
(** The distributions with which this version of frobc is tested: the beginning of the version of
    their package [rcl], and the name. *)

val untried : unit -> string option
(** A warning for the user if the installation is not of one of these distributions. *)
