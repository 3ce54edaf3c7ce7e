(** The reset, start and step function of a node. *)

val reset : Vocabulary.t -> int -> Ir.function_

val start : Vocabulary.t -> int -> Ir.function_
(** Of a node that has one. *)

val steps : Vocabulary.t -> int -> Ir.function_ list
(** One; of the root in single precision two: the step whose dt is in whole
    nanoseconds, and the one in seconds that calls it. *)
