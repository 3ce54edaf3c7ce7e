(** String literals in Frob syntax. *)

val written : string -> string
(** The text in quotes, with a backslash before each character that requires one. *)
