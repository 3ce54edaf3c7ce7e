(** A progress line on standard error that overwrites itself. Nothing is printed if standard error
    is not a terminal. *)

type t

val start : string -> total:int -> t
(** Starts a progress line with this label for [total] runs. *)

val add : t -> int -> unit
(** Adds newly finished runs to the count, and estimates the remaining time from the time elapsed so
    far. *)

val finish : t -> unit
(** Erases the line. *)
