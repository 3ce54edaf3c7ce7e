(** Texts in SVG and JUnit's files. *)

val escaped : string -> string
(** As it stands between tags or in quotes. *)
