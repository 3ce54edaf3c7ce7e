(** The line ends of a text: [\n], or [\r\n] as on Windows. *)

type t = Lf | Crlf

val of_text : string -> t
(** The kind of line end of the text's first line. *)

val write : t -> string -> string
(** Converts all line ends of the text. *)
