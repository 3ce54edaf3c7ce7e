(** A trace in a file, drawn. *)

val picture : units:(string -> string) -> string -> (string, string) result
(** The trace's path; the picture as SVG. [units] of a column, by its name without the numbers of
    elements. The error is a text for the user. *)
