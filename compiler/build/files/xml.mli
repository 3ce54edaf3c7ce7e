(** Escapes text for SVG and JUnit files. *)

val escaped : string -> string
(** Escapes the characters that may not occur literally between tags or in quoted attributes. *)
