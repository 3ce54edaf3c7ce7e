(** Words that a program uses as unit variables, such as [value] in [Float[value]]. *)

val advice : string -> int -> string -> (string * string) option
(** The letter to write instead of the word at this offset of a text, and the advice to do so.
    [None] if the word is not in the brackets of a type in a signature. *)
