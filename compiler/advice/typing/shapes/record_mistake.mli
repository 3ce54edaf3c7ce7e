(** Rules for a record where one of its fields is expected, and the reverse. *)

val built : Shape_fact.rule
(** A number or a [Bool] where a record is expected; the hint shows how to build the record. *)

val in_place_of_a_number : Shape_fact.rule
(** A record where a number is expected; the hint lists the fields of the record. *)

val compared_with_a_number : Shape_fact.rule
(** A number as the operand of an operator whose other operand is a record. *)

val in_place_of_a_part : Shape_fact.rule
(** A record in place of one of its fields, such as a pose in place of its position. *)
