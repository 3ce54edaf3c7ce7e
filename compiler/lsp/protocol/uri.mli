(** Names of documents. *)

val to_path : string -> string
(** Of [file:] URIs the path; any other URI is a name as it is: of a text that is nowhere saved. *)

val of_path : string -> string

val is_file : string -> bool
(** Has this URI a path? *)
