(** Diagnostics for editors: JSON objects with the field names of rustc.

    [message], [code] ([code], [explanation]), [level] ([error], [warning]),
    [spans] ([file_name], [byte_start], [byte_end], [line_start], [line_end],
    [column_start], [column_end] in characters from 1, [is_primary], [text],
    [label]), [children] (level [note], or [help] for a hint) and [rendered],
    the text of {!Render_text}. *)

val diagnostic : Source.t -> Diagnostic.t -> string
(** One object, without a line end. *)

val diagnostics : Source.t -> Diagnostic.t list -> string
(** One object a line. *)
