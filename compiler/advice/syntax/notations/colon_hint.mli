(** Hints about a colon, which begins a block, a branch, a slice or a type in other languages. *)

open Basis

type t = {
  hint : Diagnostic.hint option;
  instead : string option;  (** the text to write instead *)
}

val of_colon : string -> int -> t
(** The hint for the colon at this offset of the text. *)

val of_elements : string
(** The hint that suggests a replacement for a function that deconstructs a list. *)

val of_each_line : Diagnostic.hint -> Diagnostic.topic list
(** The topics of the hints that this hint makes superfluous for later colons. *)
