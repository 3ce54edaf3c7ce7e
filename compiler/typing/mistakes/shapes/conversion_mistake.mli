(** Rules for values of one type where another is expected that can be made of them. *)

val of_a_number : Shape_fact.rule
(** A number where a type of the library is expected that functions make of numbers. *)

val of_a_text : Shape_fact.rule
(** A text where a number is expected: texts are labels only. *)

val by_a_constructor : Shape_fact.rule
(** A value where a type is expected that has a constructor for such values. *)

val to_a_choice : Shape_fact.rule
(** A value where an enumeration with few cases is expected. *)
