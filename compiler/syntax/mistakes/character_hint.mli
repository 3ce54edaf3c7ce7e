(** What a character may have been meant for that Frob does not have.

    Most of them are of other languages, where they have a meaning; others are of keyboards that
    write `≤` for `<=`. *)

type t = {
  hint : string option;
  instead : string option;  (** what is to be written in its place *)
}

val of_character : text:string -> at:int -> string -> t
(** Of this character, which the text has at that place. *)

val of_block : string
(** What is said of a colon that ends a line, as Python's blocks have it. *)
