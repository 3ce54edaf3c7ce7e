(** Names and texts from outside, as a terminal may get them. *)

val name : string -> string
(** On one line, and with decimal codes in place of control characters: an escape is [\027]. *)

val text : string -> string
(** Likewise, but of several lines. *)
