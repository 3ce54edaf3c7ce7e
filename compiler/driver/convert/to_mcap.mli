(** A recording as MCAP: its values for plots, and what can be shown in space or as an image.

    The file itself is attached, so that it can be had again, byte for byte. Topics: a group of
    columns each ([/in], [/out], [/probe]) with all their values; [/pose/…] what has a position and
    a heading; [/tf] where odometry has the robot; [/ranges] echoes of range finders; [/image/…]
    frames of cameras. *)

val write : Resources.t -> Recorded.t -> out_channel -> (unit, string) result
(** Raises [Sys_error]. Frames that are not beside the recording any more are left out, with a line
    on standard error. *)
