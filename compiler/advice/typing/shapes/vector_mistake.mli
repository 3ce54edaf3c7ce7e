(** Rules for the geometry library's vectors: vectors where numbers are expected, and the reverse.
*)

val of_an_operator : Shape_fact.rule
(** A vector as the operand of an operator on numbers. *)

val of_a_number : Shape_fact.rule
(** A number as an argument where a vector is expected. *)

val of_a_tuple : Shape_fact.rule
(** The coordinates as a tuple where a vector is expected. *)
