(** What other languages do with arrays. *)

open Basis

val is_array : Type.t -> bool
val unlike_sizes : Type.t -> Type.t -> bool

val computed : Show.words -> subject:Resolve.Ir.expr option -> Expected.t -> string option
(** What computes with arrays, where an operator of numbers is given one. *)

val mapped : Expected.t -> Type.t -> (string * string * Span.t) option
(** What does to this what `map` does to arrays, in words, and where `map` stands. *)
