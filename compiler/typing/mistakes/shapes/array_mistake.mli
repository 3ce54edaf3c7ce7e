(** What other languages do with arrays. *)

open Basis

val is_array : Type.t -> bool
val unlike_sizes : Type.t -> Type.t -> bool

val computed : Show.words -> subject:Resolve.Ir.expr option -> Expected.t -> string option
(** What computes with arrays, where an operator of numbers is given one. *)

val with_each : Show.words -> subject:Resolve.Ir.expr option -> Expected.t -> string option
(** The function that computes with each of the left operand, and that operand. *)

val mapped : Expected.t -> Type.t -> (string * string * Span.t) option
(** What does to this what `map` does to arrays, in words, and where `map` stands. *)

val as_a_tuple : Show.words -> Resolve.Ir.expr option -> Type.t list -> (Span.t * string) option
(** An array written out, as the tuple of so many parts that was meant. *)

val extreme : Show.words -> Resolve.Ir.expr option -> string option
(** The cure of [max xs]. *)
