(** Generates unique names: the first request for a name gets it unchanged, later ones get the
    suffix [_2], [_3]… *)

type t

val create : unit -> t
val mem : t -> string -> bool
val unique : t -> string -> string
