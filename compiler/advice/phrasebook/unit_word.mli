(** Units written as words: [metre], [sec], [volts]. *)

val symbol : string -> string option
(** The symbol for the unit word, if it is a unit of the prelude. *)
