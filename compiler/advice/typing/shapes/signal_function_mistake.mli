(** Rules for mismatches between signal functions, functions and constant values. *)

val in_place_of_a_test : Shape_fact.rule
(** A value or signal function where a test is expected. A test of a signal function also states how
    long to run it. *)

val comparison_without_input : Shape_fact.rule
(** A comparison of a function with a value where a signal function is expected. *)

val condition_of_an_event : Shape_fact.rule
(** A function or signal function with Boolean results where a signal function that outputs events
    is expected. *)

val function_not_lifted : Shape_fact.rule
(** A function where a signal function is expected; [arr] converts it. *)

val in_place_of_a_function : Shape_fact.rule
(** A signal function where a function is expected. *)

val conditions : Shape_fact.rule
(** A condition as an operand of an operator on signal functions, as in [x > 0 &&& y > 0]. *)

val choice : Shape_fact.rule
(** A condition as the first argument of [switch]; the hint suggests [if]. *)

val constant : Shape_fact.rule
(** A value where a signal function is expected. *)
