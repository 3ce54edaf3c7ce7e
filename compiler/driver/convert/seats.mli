(** Where the range finders of a robot of the library sit and look. *)

type seat = { column : string; x : float; y : float; heading : float; half_angle : float }
(** [column]: of its echoes, such as [in.sonar[3]]; m and rad, in the robot's frame. *)

val of_columns : Resources.t -> string list -> seat list
(** Of the robot whose recordings have such columns; none of another. *)
