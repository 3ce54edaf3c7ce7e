(** What runs of sweeps came to, in files that only grow.

    A line for each run, as the host wrote it ([hosts/sim/many.h]): its key, its cells, and a
    checksum. The key is a digest of all that the run depends on; so a line is of use for whatever
    plan has that run, and two of one key say the same. What is not whole, as when a process was
    killed in the middle of a line or a disk was full, is as if it were not there. *)

type t

val create : unit -> t

val load : t -> string -> unit
(** All lines of the folder's files, if it is there. Raises [Sys_error] for what cannot be read. *)

val load_file : t -> string -> unit

val find : t -> string -> string list option
(** The cells of the run with this key. *)

val fresh : string -> string
(** The path of a file in the folder that is not there yet, and that nobody else takes. *)
