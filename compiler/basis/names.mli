(** Names that must differ: the first user of a name has it as it is, later ones get [_2], [_3]… *)

type t

val create : unit -> t
val mem : t -> string -> bool
val unique : t -> string -> string
