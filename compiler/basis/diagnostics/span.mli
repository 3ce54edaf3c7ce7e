(** Places in source text.

    Columns count bytes from 1; the renderers turn them into what a reader sees. The end is
    exclusive. A span lies in one file. *)

type position = private int
(** Of two positions in a file the later is the greater number. *)

val position : line:int -> column:int -> position
(** Neither may be negative. Columns from 2{^ 28} on are not told apart. *)

val line : position -> int
val column : position -> int

val forward : int -> position -> position
(** So many columns to the right. *)

type t = {
  file : string;  (** the name under which {!Source} knows the text *)
  start : position;
  stop : position;  (** exclusive *)
}

val make : file:string -> start:position -> stop:position -> t

val merge : t -> t -> t
(** The smallest span that covers both; they must lie in one file, else the first is returned. *)

val compare : t -> t -> int
(** By file, then start, then stop. *)

val start_of_file : string -> t
(** An empty span at line 1, column 1: for what a file as a whole lacks. *)

val pp : Format.formatter -> t -> unit
(** [file:line:column], the start. *)
