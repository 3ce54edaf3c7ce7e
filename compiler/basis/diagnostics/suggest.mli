(** "Did you mean": guesses which name the user meant by a misspelt one. *)

val closest : string -> string list -> string option
(** [closest name candidates] is the candidate with the smallest edit distance from [name]
    (inserting, deleting or replacing a character, or swapping two neighbours), if that is
    plausible: at most one edit per three characters, and at most three. A difference only in case
    counts as distance 0. Ties are broken alphabetically, so the order of [candidates] is
    irrelevant. Otherwise, the result is the only candidate with the same words in another order,
    such as [wallFollow] for [followWall]. For a single character, the only suggestion is the same
    letter in the other case. *)
