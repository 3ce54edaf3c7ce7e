(** The library's records for messages that are parts of other messages. *)

val all : ((string * string) * (string * string * string)) list
(** For each message, given by its package and name: the module that has its record, the name to
    import, and the type. *)
