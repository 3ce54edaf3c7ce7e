(** The report as human-readable text in aligned columns. *)

val to_string : ?judged:Judged.t -> ?wire:Wire.t -> Bounds.t -> string
(** Pass [judged] if the program contains assertions, and [wire] if the resolution of the robot's
    protocol is known. *)
