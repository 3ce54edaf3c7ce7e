(** The C compiler on this machine, and what it makes of generated C. *)

val flags : string list
(** With which generated C must be built to keep its promises: no contraction
    of floating-point operations. *)

(** The user's C: files to compile or link, and where headers are included from. *)
type foreign = { sources : string list; folders : string list }

type kind =
  | Shared_object  (** for a host that loads it *)
  | Executable  (** one of the archives has the host, and its [main] *)

val build :
  kind ->
  headers:string ->
  archives:string list ->
  foreign:foreign option ->
  name:string ->
  (string * string) list ->
  (string, string) result
(** [build kind ~headers ~archives ~foreign ~name files] compiles the [.c]
    files among [files] (name and content), links them with the archives, and
    gives the path of the result. Results are kept in the user's cache
    ([XDG_CACHE_HOME], or [~/.cache]), under a name made from everything that
    matters, so the same program is compiled once; with files of the user's,
    each time. The error is a text for the user. *)
