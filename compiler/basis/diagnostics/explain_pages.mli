(** Generated from the pages in [compiler/explain/]. *)

val all : (string * string) list
(** Code and page, in order of the codes. *)
