(** Temporary folders, which exist only while this process (or the program that replaces it) is
    running. *)

val folder : unit -> string
(** A new folder in [TMPDIR] or [/tmp] that only the user can access. It is removed when this
    process and the processes it started have ended, even if they were killed. Raises
    [Unix.Unix_error] if it cannot be created. *)

val remove : string -> unit
(** Removes a file, or a folder with its contents, as far as possible. *)
