(** Escapes text for SVG and JUnit files. *)

val escaped : string -> string
(** The text with characters escaped as required between tags or in quotes. *)
