(** Rules for tuples where other values, or other tuples, are expected. *)

val selected : Shape_fact.rule
(** [p.1], where `.` composes functions and does not select a component. *)

val parameter : Shape_fact.rule
(** A single value as the argument of a function that takes one tuple. *)

val of_another_length : Shape_fact.rule
(** Tuples with different numbers of components. *)

val written_as_an_array : Shape_fact.rule
(** An array literal with as many elements as the expected tuple has components. *)

val of_more_than_two : Shape_fact.rule
(** Three or more values for a function of two, such as [min(x, y, z)]. *)

val of_all_arguments : Shape_fact.rule
(** [max(x, 0)], where [max] also accepts a tuple as its first argument. *)

val mapped_range : Shape_fact.rule
(** [map(x, 0, 1023, 0, 5)], as in an Arduino program. *)

val without_winner : Shape_fact.rule
(** [latch (set, reset)] without its first argument. *)

val separated_by_commas : Shape_fact.rule
(** The C-style call [f(x, y)]. *)

val of_a_decimal_comma : Shape_fact.rule
(** [0,4[m]] in place of [0.4[m]]. *)

val of_an_input : Shape_fact.rule
(** An input that is a tuple, used as a number. *)

val of_a_function_and_its_argument : Shape_fact.rule
(** [(f x, y)] in place of [f x y]. *)
