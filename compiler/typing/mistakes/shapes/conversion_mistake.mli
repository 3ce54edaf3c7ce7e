(** Rules for values that can be converted to the expected type. *)

val of_a_number : Shape_fact.rule
(** A number where a library type is expected that functions create from numbers. *)

val of_a_text : Shape_fact.rule
(** A string where a number is expected: strings are only labels. *)

val by_a_constructor : Shape_fact.rule
(** A value where the expected type has a constructor for such values. *)

val capital_choice : Shape_fact.rule
(** A name in place of the constructor that differs only in its first letter. *)

val to_a_choice : Shape_fact.rule
(** A value where an enumeration with few cases is expected. *)
