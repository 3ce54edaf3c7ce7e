(** Formats lists for use in a sentence. *)

val all : string list -> string
(** [a], [a and b], or [a, b and c]. *)

val one_of : string list -> string
(** [a], [a or b], or [a, b or c]. *)

val some : string list -> more:int -> string
(** [a, b and 2 more]; like {!all} if [more] is 0. *)

val circle : string list -> string
(** [`a → b → a`] for [a; b]. Only the beginning and the end of a very long cycle are shown. If the
    list repeats a shorter cycle, that cycle is shown once. *)
