(** Writes untrusted text into C, as a string literal or as a comment. *)

val literal : string -> string
(** A string literal that a C compiler reads as exactly these bytes. Escapes quotes, control
    characters, and pairs of question marks, which begin trigraphs. *)

val comment : string -> string
(** The text, made safe for use inside a C comment: it neither ends the comment nor begins another
    one, and it contains no trigraphs or control characters. *)
