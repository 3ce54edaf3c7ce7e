(** Rules for mismatches between signal functions, functions and constant values. *)

val in_place_of_a_test : Shape_fact.rule
(** A signal function of truth values where a test is expected, which says how long it must hold. *)

val condition_of_an_event : Shape_fact.rule
(** A function to truth values where a signal function of events is expected. *)

val function_not_lifted : Shape_fact.rule
(** A function where a signal function is expected: [arr] makes one of it. *)

val in_place_of_a_function : Shape_fact.rule
(** A signal function where a function is expected. *)

val constant : Shape_fact.rule
(** A value where a signal function is expected. *)
