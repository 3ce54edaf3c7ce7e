(** The poses of the range finders on the library's robots. *)

type seat = { column : string; x : float; y : float; heading : float; half_angle : float }
(** [column] is the column that contains the sensor's echoes, such as [in.sonar[3]]. The pose is in
    m and rad, in the robot's frame. *)

val of_columns : Resources.t -> string list -> seat list
(** The range finders of the robot whose recordings have these columns. Empty if the robot is
    unknown. *)
