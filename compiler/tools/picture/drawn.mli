(** Draws a trace file. *)

val picture : units:(string -> string) -> string -> (string, string) result
(** Takes the path of the trace and returns the picture as SVG. [units] maps the name of a column,
    without indices, to its unit. The error is a message for the user. *)
