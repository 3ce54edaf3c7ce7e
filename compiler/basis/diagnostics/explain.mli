(** Explanations of the diagnostic codes: the pages of [compiler/explain/], embedded when the
    compiler is built. *)

val find : string -> string option
(** The page for a code such as ["E0401"], in Markdown. *)

val codes : string list
(** Every code that has a page, in order. *)
