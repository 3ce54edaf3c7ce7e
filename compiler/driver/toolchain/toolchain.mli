(** The C compiler on this machine, and what it makes of generated C. *)

val flags : string list
(** With which generated C must be built to keep its promises: no contraction of floating-point
    operations. *)

type foreign = { sources : string list; folders : string list }
(** The user's C and C++: files to compile or link, and where headers are included from. *)

type kind =
  | Shared_object  (** for a host that loads it *)
  | Executable  (** one of the inputs has the host, and its [main] *)

type machine = {
  compiler : string;  (** the program *)
  cure : string;  (** what to do if it is missing *)
  options : string list;  (** beyond {!flags} *)
}

val this_machine : unit -> machine
(** With the compiler of [CC], else [cc]. *)

val build :
  ?machine:machine ->
  kind ->
  headers:string ->
  inputs:string list ->
  ?includes:string list ->
  foreign:foreign option ->
  name:string ->
  (string * string) list ->
  (string, string) result
(** [build kind ~headers ~inputs ~includes ~foreign ~name files] compiles the [.c] files among
    [files] (name and content), links them with the archives and sources [inputs], which include
    [includes], and gives the path of the result; for this machine, with its C compiler, unless told
    otherwise. Results are kept in the {!Cache}, by everything that matters, so the same program is
    compiled once; with files of the user's, each time. The error is a text for the user. *)
