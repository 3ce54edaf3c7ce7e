(** Generated names for variables that the programmer did not name. *)

type kind = Type | Size | Unit | Representation

val nth : kind -> int -> string
(** The name with this number, from 0: [a], [b], … for types, [u], [v], … for units, [n], … for
    representations (then [n1], …). No two kinds or numbers share a name. *)
