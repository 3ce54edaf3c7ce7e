(** Converts a recording to MCAP. The result contains the recorded values for plots, and everything
    that can be displayed in 3D or as an image.

    The recording itself is attached, so that it can be restored byte for byte. Topics: one for each
    group of columns ([/in], [/out], [/probe]) with all their values; [/pose/…] for values with a
    position and a heading; [/tf] for the robot's pose from odometry; [/ranges] for echoes of range
    finders; [/image/…] for camera frames. *)

val write : Resources.t -> Recorded.t -> out_channel -> (unit, string) result
(** Raises [Sys_error]. Frames whose files are missing are skipped, with a warning on standard
    error. *)
