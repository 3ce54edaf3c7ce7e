(** The line endings of a text: [\n], or [\r\n] as on Windows. *)

type t = Lf | Crlf

val of_text : string -> t
(** The kind of the text's first line ending. *)

val write : t -> string -> string
(** Converts all line endings of the text to this kind. *)
