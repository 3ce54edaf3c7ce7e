(** The recorded input of the programs of {!Selftest}: the same on every machine. *)

type row = { time_ns : int; cells : string list  (** of [Sample], in the order of its columns *) }

val rows : unit -> row list
(** First tame numbers, so that what has a state goes through all that it can; then NaN, infinities,
    both zeros and numbers at the edges of their type. *)

val csv : row list -> string
(** Rows as a trace. *)
