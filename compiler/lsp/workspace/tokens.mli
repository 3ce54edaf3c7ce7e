(** Splits a text into tokens. The text need not be a program. *)

type token = { token : Syntax.Grammar.token; start : int; stop : int;  (** offsets *) first : bool }

val of_text : string -> token array
(** The tokens, without the end-of-text token. *)

val item : string -> int -> int * int
(** The range of the top-level declaration that contains the offset: from a line that is not
    indented to the next such line. *)
