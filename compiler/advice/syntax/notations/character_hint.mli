(** Hints about characters that Frob does not use.

    Most of them have a meaning in other languages. Others are typographic variants such as `≤` for
    `<=`. *)

type t = { hint : string option; instead : string option  (** the text to write instead *) }

val of_character : text:string -> at:int -> string -> t
(** The hint for this character, which occurs at this offset of the text. *)

val of_elements : string
(** The hint that suggests a replacement for a function that takes a list apart. *)

val of_each_line : string option -> string option list
(** The hints that are superfluous for later colons, once this hint has been given for a colon. *)
