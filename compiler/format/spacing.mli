(** Decides whether there is a space between two words of a line. *)

val set : Word.t array -> unit
(** Sets [gap] of all words, as if they were all on one line. *)
