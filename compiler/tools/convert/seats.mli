(** The poses of the range finders of the library's robots. *)

type seat = { column : string; x : float; y : float; heading : float; half_angle : float }
(** [column] is the column with the sensor's echoes, such as [in.sonar[3]]. The pose is in m and
    rad, in the robot's frame. *)

val of_columns : Resources.t -> string list -> seat list
(** The range finders of the robot whose recordings have these columns; empty for an unknown robot.
*)
