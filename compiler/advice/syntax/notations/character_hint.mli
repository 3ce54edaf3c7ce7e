(** Hints about characters that Frob does not use.

    Most of them have a meaning in other languages. Others are typographic variants such as `≤` for
    `<=`. Hints about colons are in {!Colon_hint}. *)

type t = Colon_hint.t = { hint : Basis.Diagnostic.hint option; instead : string option }

val of_character : text:string -> at:int -> string -> t
(** The hint for this character, which occurs at this offset in the text. *)
