(** Sequences of numbers, each known by one number, its key. *)

type t
(** All sequences so far. *)

val create : unit -> t

val empty : int
(** The key of the empty sequence. *)

val add : t -> int -> int -> int
(** The key of a sequence with one more number behind it. *)

val text : t -> string -> int
(** A number for a text. *)
