(** The user's own headers that C files include in quotes, directly or through other headers. *)

val read : string -> (string, string) result
(** Reads a file. The error says why it cannot be read. *)

val is_header : string -> bool
(** Decides by the file name extension. *)

val reached : generated:string list -> folders:string list -> string list -> string list
(** These files, and the files that they include in quotes, directly or through other files.
    [generated] lists the names of files that [frobc] writes itself. Searches for an included file
    in the folder of the including file, then in [folders]; omits files that it does not find. *)

val includes : string list -> folders:string list -> string -> bool
(** Whether the file includes a header with one of these names in quotes, directly or through other
    files. *)

type t = {
  path : string;  (** path of the file *)
  name : string;
      (** path relative to the folder of the including files, as if these were all in one folder *)
}

val of_sources : string list -> (t list, string) result
(** The headers found next to these files. Headers that are not found are assumed to be part of the
    runtime, or generated. Headers next to different files may have the same name and different
    texts. The error names a file that cannot be read, or that includes a file outside of its
    folder. *)

val of_text : folders:string list -> string -> (t list, string) result
(** Like {!of_sources}, but for the text of a generated file, whose includes are searched for in
    these folders. *)
