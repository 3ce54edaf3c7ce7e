(** Several things in a sentence. *)

val all : string list -> string
(** [a], [a and b], [a, b and c]. *)

val one_of : string list -> string
(** [a], [a or b], [a, b or c]. *)

val some : string list -> more:int -> string
(** [a, b and 2 more]; without more as {!all}. *)
