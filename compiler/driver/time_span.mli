(** Lengths of time on the command line: [60s], [500ms], [2min]. *)

val parse : string -> (float, string) result
(** In seconds; positive and finite. The error is a text for the user. *)

val parse_instant : string -> (float, string) result
(** A time since the start: [0s] as well. *)

val print : float -> string
(** As {!parse_instant} reads it, to the nanosecond. *)
