(** Units written as words: [metre], [sec], [volts]. *)

val symbol : string -> string option
(** The symbol of the unit that the word names, if the prelude has it. *)
