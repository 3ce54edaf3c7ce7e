(** Words with their columns to text: here the comments find their places. *)

val text : Reading.t -> Indentation.t -> string
