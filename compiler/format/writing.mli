(** Converts words and their columns to text, and places the comments. *)

val text : Reading.t -> Indentation.t -> string
