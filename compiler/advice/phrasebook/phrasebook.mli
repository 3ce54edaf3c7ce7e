(** Words from other languages, from the table [words.txt]. The head of that file explains the rows.
*)

val rows : Phrase.t list Lazy.t
(** All rows, in the order of the table. *)

val find : Phrase.place -> string -> Phrase.t option
(** The first row for the word at this place. *)

val hint : Phrase.t -> string
(** The hint in the row or, if there is none, a hint that suggests the replacement. *)

val name : Phrase.t -> string option
(** The replacement, if it is one word and the row has no hint. *)

val applied : Phrase.place -> string -> string list -> (string * Phrase.t) option
(** Finds the first row for the word at this place with this number of arguments. Returns its
    replacement, with these arguments substituted, and the row. *)

val with_arguments : (string * string) list -> string -> string
(** Replaces each of these names in the text with the text for it. *)
