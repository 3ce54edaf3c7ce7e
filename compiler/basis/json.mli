(** JSON as we write it: one line, the members of objects in the given order. *)

type t =
  | Null
  | Bool of bool
  | Int of int
  | Float of float  (** finite *)
  | String of string  (** bytes that are no UTF-8 become [U+FFFD] *)
  | List of t list
  | Object of (string * t) list

val to_string : t -> string
