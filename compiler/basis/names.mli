(** Generates unique names. The first request for a name returns it unchanged; later requests add
    the suffix [_2], [_3]… *)

type t

val create : unit -> t
val mem : t -> string -> bool
val unique : t -> string -> string
