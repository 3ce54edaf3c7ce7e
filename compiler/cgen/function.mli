(** The reset and step function of a node. *)

val reset : Vocabulary.t -> int -> Ir.function_
val step : Vocabulary.t -> int -> Ir.function_
