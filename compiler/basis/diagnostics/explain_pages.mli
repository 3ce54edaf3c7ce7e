(** Generated from the pages in [compiler/explain/]. *)

val all : (string * string) list
(** Pairs of a code and its page, sorted by code. *)
