(** The report for people: aligned columns. *)

val to_string : Bounds.t -> string
