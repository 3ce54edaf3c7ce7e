(** JSON, read and written by Yojson.

    All resulting strings are valid UTF-8: bytes that are not UTF-8 become [U+FFFD]. *)

type t =
  | Null
  | Bool of bool
  | Int of int
  | Float of float  (** written as [null] if it is not finite *)
  | String of string
  | List of t list
  | Object of (string * t) list

val to_string : t -> string
(** Writes JSON on one line, with the members of objects in the given order. *)

val of_string : string -> t option
(** [None] if the text is not JSON, or is nested more than 500 levels deep. *)

(** {1 Access}

    If a member is missing, these functions return a default. *)

val member : string -> t -> t
(** [Null] if the member is missing. *)

val at : string list -> t -> t
(** [at [a; b] json] is the member [b] of the member [a]. *)

val string : t -> string option
val int : t -> int option
val list : t -> t list
