(** Makes names and text from untrusted sources safe to print to a terminal. *)

val name : string -> string
(** The text on one line, with control characters replaced by decimal codes: an escape character
    becomes [\027]. *)

val text : string -> string
(** Like {!name}, but keeps newlines and tabs. *)

val word : string -> string
(** A word of a command that a user may copy into a shell, quoted if necessary. Control characters
    become octal escapes within [$'...']. *)

val operand : string -> string
(** A file path as a command-line argument: [./-a] for [-a], which would otherwise be read as an
    option. *)

val path : string -> string
(** A file path for a command that a user may copy: {!operand}, quoted by {!word}. *)
