(** What a character may have been meant for that Frob does not have.

    Most of them are of other languages, where they have a meaning; others are of keyboards that
    write `≤` for `<=`. *)

type t = {
  hint : string option;
  instead : string option;  (** what is to be written in its place *)
}

val of_character : text:string -> at:int -> string -> t
(** Of this character, which the text has at that place. *)

val is_of_each_line : string option -> bool
(** Of a colon that other lines are likely to have as well: it is told once. *)
