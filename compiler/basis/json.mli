(** JSON as we write it: one line, the members of objects in the given order. *)

type t =
  | Null
  | Bool of bool
  | Int of int
  | Float of float  (** finite *)
  | String of string  (** what is no UTF-8 is replaced, as {!Display} does *)
  | List of t list
  | Object of (string * t) list

val to_string : t -> string
