(** Several things in a sentence. *)

val all : string list -> string
(** [a], [a and b], [a, b and c]. *)

val one_of : string list -> string
(** [a], [a or b], [a, b or c]. *)

val some : string list -> more:int -> string
(** [a, b and 2 more]; without more as {!all}. *)

val circle : string list -> string
(** [`a → b → a`] of [a; b]; of a circle too long to read, the beginning and the end. What comes
    again is shown once. *)
