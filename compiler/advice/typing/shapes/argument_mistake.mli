(** Rules for missing arguments, for one argument too many, and for values where functions are
    expected. *)

open Typing

val missing_arguments : Type.t -> int
(** The number of arguments that a function of this type takes. *)

val missing : Shape_fact.rule
(** A function where a value is expected; the hint lists the missing arguments. *)

val more_missing_than_expected : Shape_fact.rule
(** A function that still needs more arguments than a function of the expected type takes. *)

val lambda_with_too_few_parameters : Shape_fact.rule
(** The body of a lambda that is called with one more argument than it has parameters. *)

val missing_in_an_operand : Shape_fact.rule
(** A number and a function that lacks its last argument, as operands of the same operator. *)

val composed : Shape_fact.rule
(** A tuple of functions where a function is expected. *)

val one_too_many : Shape_fact.rule
(** A value where a function is expected, such as [f x] in place of [f]. *)

val missing_before : Shape_fact.rule
(** An event or a condition that fits the next parameter of the function: the argument before it is
    missing. *)
