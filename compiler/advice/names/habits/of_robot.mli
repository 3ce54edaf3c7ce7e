(** Hints for an unknown value that nothing else explains: a similar name, or a word that other
    robot libraries use for a sensor or an action. *)

open Basis

val is_a_word : string -> bool
(** Does another robot library use this word? *)

val diagnostic : Suggestion.t -> Unknown.t -> Diagnostic.t
(** With a hint, if one can be found. *)
