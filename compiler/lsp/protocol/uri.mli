(** Converts URIs of documents to paths and back. *)

val to_path : string -> string
(** The path of a [file:] URI. Any other URI, such as that of an unsaved text, is returned
    unchanged. *)

val of_path : string -> string

val is_file : string -> bool
(** Is this a [file:] URI, which has a path? *)
