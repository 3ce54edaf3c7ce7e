(** The recorded input for the programs of {!Selftest}. It is the same on every machine. *)

type row = { time_ns : int; cells : string list  (** cells in the order of [Sample]'s columns *) }

val rows : Basis.Real.t -> row list
(** The first rows contain moderate numbers, so that programs go through all their states. The other
    rows add NaN, infinities, both zeros, and numbers at the limits of their types. *)

val csv : row list -> string
(** Formats the rows as a trace. *)
