(** Rules for values of other types where a truth value is expected, and the reverse. *)

val condition : Shape_fact.rule
(** An [if] condition that is not a truth value. *)

val of_events : Shape_fact.rule
(** A Boolean operator that is applied to an event. *)

val part_of_a_comparison : Shape_fact.rule
(** [when frontSonar i < 1[m]], where the parentheses around the comparison are missing. *)

val grouped_with_an_argument : Shape_fact.rule
(** [not x > 0], in which [not] is applied only to [x]. *)

val equal_to_a_truth : Shape_fact.rule
(** [b == 1], where [b] is a truth value. *)

val grouped_with_an_operand : Shape_fact.rule
(** Like {!grouped_with_an_argument}, if the mismatch is between the application and the other
    operand of the operator. *)

val compared : Shape_fact.rule
(** A number where a comparison was probably meant. *)

val in_place_of_a_number : Shape_fact.rule
(** A truth value where a number is expected. *)
