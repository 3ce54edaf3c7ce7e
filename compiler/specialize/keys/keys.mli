(** Assigns each sequence of numbers a unique number, its key. *)

type t
(** The table of all sequences seen so far. *)

val create : unit -> t

val empty : int
(** The key of the empty sequence. *)

val add : t -> int -> int -> int
(** The key of the sequence extended by one number. *)

val text : t -> string -> int
(** A unique number for a string. *)
