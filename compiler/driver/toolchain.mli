(** The C compiler on this machine, and what it makes of generated C. *)

val flags : string list
(** With which generated C must be built to keep its promises: no contraction
    of floating-point operations. *)

(** The user's C: files to compile or link, and where headers are included from. *)
type foreign = { sources : string list; folders : string list }

val shared_object :
  headers:string ->
  runtime:string ->
  foreign:foreign option ->
  name:string ->
  (string * string) list ->
  (string, string) result
(** [shared_object ~headers ~runtime ~name files] compiles the [.c] files among
    [files] (name and content) into a shared object, links it with the archive
    [runtime], and gives its path. Results are
    kept in the user's cache ([XDG_CACHE_HOME], or [~/.cache]), under a name
    made from everything that matters, so the same program is compiled once;
    with files of the user's, each time.
    The error is a text for the user. *)
