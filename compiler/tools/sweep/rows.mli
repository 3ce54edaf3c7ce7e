(** The results of a sweep's runs, in append-only files.

    Each line is the result of a run, as the host writes it ([hosts/sim/many.h]): its key, its
    cells, and a checksum. The key is a digest of everything that the run depends on. Any plan that
    contains the same run can use the line, and lines with equal keys are equal. Incomplete lines,
    which occur when a process is killed or the disk is full, are ignored. *)

type t

val create : unit -> t

val load : t -> string -> unit
(** Loads all lines of the files in a folder, if the folder exists. Raises [Sys_error] if a file
    cannot be read. *)

val load_file : t -> string -> unit

val find : t -> string -> string list option
(** The cells of the run with this key. *)

val fresh : string -> string * Unix.file_descr
(** Creates a file in the folder, and opens it for writing. Raises [Unix.Unix_error] if that is not
    possible. *)
