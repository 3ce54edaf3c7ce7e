(** Diagnostics for editors, as JSON objects with the field names of rustc.

    [message], [code] ([code], [explanation]), [level] ([error], [warning]), [spans] ([file_name],
    [byte_start], [byte_end], [line_start], [line_end], [column_start], [column_end] in characters
    from 1, [is_primary], [text], [label]), [children] (level [note], or [help] for a hint) and
    [rendered], the text of {!Render_text}. There is one field that rustc does not have: [fixes].
    Each fix has a [title], a flag [safe] (whether a tool may apply it without asking) and [edits].
    Each edit has a [span] (the fields [file_name] to [column_end]) and the replacement [text]. *)

val diagnostics : Source.t -> Diagnostic.t list -> string
(** One object per line, for the first 1,000 errors and the first 1,000 warnings. If there are more,
    the last object counts them: its [level] is [note], its [code] is null, it has no [spans], and
    it alone has a field [left_out], with the numbers of [errors] and [warnings] that are not shown.
*)
