(** Names for variables that the programmer did not name. *)

type kind = Type | Size | Unit | Representation

val nth : kind -> int -> string
(** From 0: [a], [b], … for types, [u], [v], … for units, [n], … for representations (then [n1], …);
    never the same for two kinds or two numbers. *)
