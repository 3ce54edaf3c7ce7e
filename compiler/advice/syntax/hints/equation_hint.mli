(** Hints about equations and the statements of a `do`. *)

val split_by_value : Found.rule
(** `x<-1`, meaning `x < -1`. *)

val outside_do : Found.rule
(** A statement outside a `do`. *)

val outside_proc : Found.rule
(** A command outside a `proc`. *)

val changed : Found.rule
(** [x += 1] or [x != 1]. *)

val in_a_choice : Found.rule
(** An equation after `then` or `else`. *)

val keyword_argument : Found.rule
(** [f (v = 1)], a keyword argument. *)

val changed_field : Found.rule
(** [r.speed = 1], an assignment to a field. *)

val statement : Found.rule
(** An equation among the statements of a task. *)

val without_parentheses : Found.rule
(** [a, b = p], as in Python. *)

val two_names : Found.rule
(** [y = z = x], as in C. *)

val comparison : Found.rule
(** An `=` used as a comparison. *)

val of_a_proc : Found.t -> bool
(** Is the enclosing `do` the body of a `proc`, and not a block of tasks? *)

val comma : Found.rule
(** The hint for a comma after an equation or a statement. *)
