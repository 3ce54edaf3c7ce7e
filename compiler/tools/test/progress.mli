(** A progress line on standard error that overwrites itself. Nothing is printed if standard error
    is not a terminal. *)

type t

val start : string -> total:int -> t
(** Starts a line with this label, for a total number of runs. *)

val add : t -> int -> unit
(** Counts finished runs, and estimates the remaining time from the time they took. *)

val finish : t -> unit
(** Erases the line. *)
