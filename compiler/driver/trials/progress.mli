(** How far runs are, on a line of standard error that each look overwrites; nothing where that is
    no terminal. *)

type t

val start : string -> total:int -> t
(** Of so many runs, under a name. *)

val add : t -> int -> unit
(** So many more are done. The line has the time that is left, as the runs so far took. *)

val finish : t -> unit
(** Takes the line away. *)
