(** The library's records for messages that are parts of other messages. *)

val all : ((string * string) * (string * string * string)) list
(** Maps the package and name of each message to its record: the module that declares the record,
    the name to import, and the type. *)
