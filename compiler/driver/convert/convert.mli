(** [frobc convert]: recordings as MCAP, and back; and from one compression to another. *)

val run : string -> string -> int
(** [run from path]: what is at the end of their names says what they are. The exit status. *)
