(** Writes JSON on one line, with object members in the given order. *)

type t =
  | Null
  | Bool of bool
  | Int of int
  | Float of float  (** [null] if it is not finite *)
  | String of string  (** invalid UTF-8 becomes [U+FFFD] *)
  | List of t list
  | Object of (string * t) list

val to_string : t -> string
