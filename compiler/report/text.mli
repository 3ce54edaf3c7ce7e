(** The report for people: aligned columns. *)

val to_string : ?judged:Judged.t -> Bounds.t -> string
(** [judged]: if the program asserts anything. *)
