(** Rules for values that can be converted to the expected type. *)

val of_seeds : Shape_fact.rule
(** An array in place of the seeds of a trial. *)

val of_a_number : Shape_fact.rule
(** A number where a value of a library type is expected, if library functions create such values
    from numbers. *)

val of_a_text : Shape_fact.rule
(** A string where a number is expected: strings are only labels. *)

val by_a_constructor : Shape_fact.rule
(** A value that a constructor of the expected type takes as a field. *)

val capital_choice : Shape_fact.rule
(** A name in place of a constructor that differs from it only in the case of the first letter. *)

val verdict_of_a_truth : Shape_fact.rule
(** A `Bool` where a `Verdict` is expected. *)

val to_a_choice : Shape_fact.rule
(** A constructor, literal or `Bool` where another enumeration with few cases is expected. *)
