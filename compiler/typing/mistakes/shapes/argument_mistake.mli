(** Rules for missing arguments, for one argument too many, and for values where functions are
    expected. *)

val missing_arguments : Type.t -> int
(** How many arguments a function of this type takes. *)

val missing : Shape_fact.rule
(** A function where a value is expected: the arguments that it lacks. *)

val more_missing_than_expected : Shape_fact.rule
(** A function that lacks more arguments than the expected function takes. *)

val lambda_with_too_few_parameters : Shape_fact.rule
(** The body of a lambda whose caller gives it one argument more. *)

val missing_in_an_operand : Shape_fact.rule
(** An operand whose other operand is a function that lacks its last argument. *)

val composed : Shape_fact.rule
(** A tuple of functions where a function is expected. *)

val one_too_many : Shape_fact.rule
(** The result of a function where the function itself is expected, or any other value there. *)
