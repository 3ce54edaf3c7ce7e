(** The report for people: aligned columns. *)

val to_string : ?judged:Judged.t -> ?wire:Wire.t -> Bounds.t -> string
(** [judged] is present if the program contains assertions, and [wire] if the resolution of the
    robot's protocol is known. *)
