(** Texts as the language writes them. *)

val written : string -> string
(** In quotes, with a backslash before what needs one. *)
