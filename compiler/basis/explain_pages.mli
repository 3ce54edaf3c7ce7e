(** Generated from [compiler/explain/*.md]. *)

val all : (string * string) list
(** Code and page, in order of the codes. *)
