(** The records of the library for messages that are parts of other messages. *)

val all : ((string * string) * (string * string * string)) list
(** By package and name: the module, the name to import, and the type. *)
