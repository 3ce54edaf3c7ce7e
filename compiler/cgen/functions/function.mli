(** The reset and step function of a node. *)

val reset : Vocabulary.t -> int -> Ir.function_

val steps : Vocabulary.t -> int -> Ir.function_ list
(** One; of the root in single precision two: the step whose dt is in whole nanoseconds, and the one
    in seconds that calls it. *)
