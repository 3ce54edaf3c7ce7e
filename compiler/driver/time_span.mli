(** Lengths of time on the command line: [60s], [500ms], [2min]. *)

val parse : string -> (float, string) result
(** In seconds; positive and finite. The error is a text for the user. *)
