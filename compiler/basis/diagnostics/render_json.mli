(** Diagnostics for editors: JSON objects with the field names of rustc.

    [message], [code] ([code], [explanation]), [level] ([error], [warning]), [spans] ([file_name],
    [byte_start], [byte_end], [line_start], [line_end], [column_start], [column_end] in characters
    from 1, [is_primary], [text], [label]), [children] (level [note], or [help] for a hint) and
    [rendered], the text of {!Render_text}. Beside those of rustc, [fixes]: each with a [title],
    whether it is [safe] to make unasked, and [edits]: a [span] ([file_name] to [column_end] as
    above) and the [text] that it becomes. *)

val diagnostics : Source.t -> Diagnostic.t list -> string
(** One object a line. *)
