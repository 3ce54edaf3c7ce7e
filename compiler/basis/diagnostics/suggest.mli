(** "Did you mean": the name that a misspelt one was probably meant to be. *)

val closest : string -> string list -> string option
(** [closest name candidates] is the candidate nearest to [name] by edits (insert, delete, replace a
    character, swap two neighbours), if it is near enough to be likely: one edit for each three
    characters, at most three. A name that differs only in capitals is nearest. Of equally near ones
    it is the first in alphabetical order, so the order of [candidates] is irrelevant. A single
    character suggests nothing but its other case. *)
