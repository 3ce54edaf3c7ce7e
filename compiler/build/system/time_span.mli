(** Time spans on the command line: [60s], [500ms], [2min], [1h]. *)

val parse : string -> (float, string) result
(** Converts a span to seconds, which must be positive and finite. The error is a message for the
    user. *)

val parse_instant : string -> (float, string) result
(** Parses a time since the start, which may be [0s]. *)

val print : float -> string
(** Formats a time, to the nanosecond, as text that {!parse_instant} reads. *)
