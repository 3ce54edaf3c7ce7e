(** Places in source text.

    Columns count bytes from 1; the renderers convert them to displayed columns. The end is
    exclusive. A span lies within one file. *)

type position = private int
(** Comparing these integers compares positions within one file. *)

val position : line:int -> column:int -> position
(** Line and column must not be negative. Columns from 2{^ 28} on are indistinguishable. *)

val line : position -> int
val column : position -> int

val forward : int -> position -> position
(** Moves the position to the right by this number of columns. *)

type t = {
  file : string;  (** the file's name in the {!Source} table *)
  start : position;
  stop : position;  (** exclusive *)
}

val make : file:string -> start:position -> stop:position -> t

val merge : t -> t -> t
(** The smallest span that covers both. If they are in different files, the first one. *)

val compare : t -> t -> int
(** Orders by file, then start, then stop. *)

val start_of_file : string -> t
(** An empty span at line 1, column 1, for errors that concern a file as a whole. *)

val pp : Format.formatter -> t -> unit
(** Prints the start as [file:line:column]. *)
