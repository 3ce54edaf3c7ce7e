(** Names of type variables: generated names for variables that the programmer did not name, and
    names that were probably meant as types. *)

type kind = Type | Size | Unit | Representation

val nth : kind -> int -> string
(** The name with this number, from 0: [a], [b], … for types, [u], [v], … for units, [n], … for
    representations (then [n1], …). No two kinds or numbers share a name. *)

val type_meant : string -> string option
(** The type that the programmer probably meant by this variable name: the names differ only in
    case, or other languages use this name for the type. Recognizes only a few library types. *)
