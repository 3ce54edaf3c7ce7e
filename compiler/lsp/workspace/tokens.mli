(** The words of a text, which need not be a program. *)

type token = { token : Syntax.Grammar.token; start : int; stop : int;  (** offsets *) first : bool }

val of_text : string -> token array
(** Without the end. *)

val item : string -> int -> int * int
(** From where to where the item of the top of the text goes that the offset is in: from a line that
    is not indented to the next. *)
