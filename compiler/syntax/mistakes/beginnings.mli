(** How lines begin in other languages, and what is written in Frob instead. *)

val by_equation : string
val no_procedures : string

val of_word : string -> string option
(** The cure, of the first word of a line. *)

val needless : string list
(** Words before a definition which it does not need: [const], [var] and their like. *)
