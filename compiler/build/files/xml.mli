(** Escapes texts in SVG and JUnit files. *)

val escaped : string -> string
(** The text as it is written between tags or in quotes. *)
