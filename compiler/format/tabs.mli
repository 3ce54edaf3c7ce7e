(** Replaces tabs, which the language forbids because indentation is significant. *)

val expanded : string -> string option
(** Replaces tabs with spaces. Succeeds only if the text is the same program for tab stops of 4 and
    8 columns, and no string literal contains a tab. *)
