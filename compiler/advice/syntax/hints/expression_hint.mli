(** Hints about functions, arguments and arrays. *)

val do_argument : Found.rule
(** A `do` among arguments. *)

val lambda_argument : Found.rule
(** A lambda among arguments. *)

val pattern_of_proc : Found.rule
(** A constructor pattern without parentheses as the input of a `proc`. *)

val fat_arrow : Found.rule
(** A `=>` after the input of a [proc] or the parameters of a function. *)

val function_handle : Found.rule
(** [@(x) x * 2], as in MATLAB. *)

val list_comprehension : Found.rule
(** [2 * x | x <- xs], as in Haskell. *)

val arrow_function : Found.t -> string
(** The hint for [x -> e] or [x => e] without the backslash. *)
