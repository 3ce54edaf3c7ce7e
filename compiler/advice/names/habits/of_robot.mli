(** Hints for an unknown value that no other rule explains: a similar name, or Frob's equivalent of
    a word that other robot libraries use for a sensor or an action. *)

open Basis

val is_a_word : string -> bool
(** Does another robot library use this word? *)

val diagnostic : Suggestion.t -> Unknown.t -> Diagnostic.t
(** Reports the unknown value, with a hint if a rule applies. *)
