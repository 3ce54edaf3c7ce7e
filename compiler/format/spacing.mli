(** The blanks between two words of a line: one, or none. *)

val set : Word.t array -> unit
(** Sets [gap] of all words, as if no line began with any of them. *)
