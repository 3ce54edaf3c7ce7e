(** Hints about choices: `if`, `case` and guards. *)

val matched : Found.rule
(** [match x with], as in OCaml. *)

val when_for_if : Found.rule
(** [when c then a else b]. *)

val after_value : Found.rule
(** [x if c else y], as in Python. *)

val double_arrow : Found.rule
(** A branch of a `case` with [=>] instead of [->]. *)

val branch : Found.rule
(** A branch of a `case` with [=] instead of [->]. *)

val in_braces : Found.rule
(** An `if` with its branches in braces. *)

val if_in_a_guard : Found.rule
(** [| if x > 0 = 1], a guard with an [if]. *)

val separated_guards : Found.rule
(** Guards, or the conditions of one guard, separated by commas. *)

val otherwise : Found.rule
(** A guard with `else`. *)

val without_then : Found.rule

val tuple_in_a_branch : Found.rule
(** An `else` directly after the condition. *)

val chain : Found.rule
(** A second `then`, as after [elif]. *)

val absolute_value : Found.rule
(** Bars around an expression, as in [|x|]. *)

val equation_before_guards : Found.rule
(** An `=` before the guards. *)

val without_of : Found.rule
(** A `case` whose line ends without `of`. *)

val membership : Found.rule
(** [x in xs], as in Python. *)

val of_assignments : Found.rule
(** [if (c) { y = a; } else { y = b; }], as in C. *)

val guards_after_if : Found.rule
(** The hint for [if | x > 0 -> 1 | otherwise -> 0]. *)
