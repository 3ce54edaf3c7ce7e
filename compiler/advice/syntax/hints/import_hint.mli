(** Hints about module names and imports. *)

val path : Found.rule
(** A module name written as a file path. *)

val mathematics : Found.rule
(** [import math], whose functions are built into Frob. *)

val of_library : string -> string option
(** The hint for a Python or ROS module that a Frob program does not need. *)

val of_python : Found.rule
(** [import rclpy], a Python module. *)

val capital : Found.rule
(** A module name that begins with a lower-case letter. *)

val of_haskell : Found.rule
(** A Haskell module. *)

val with_points : Found.rule
(** A module name that contains dots. *)

val hiding : Found.rule
(** [import Control hiding (limit)]. *)

val exposing : Found.rule
(** The hint for [import Control exposing (pid)], as in Elm. *)
