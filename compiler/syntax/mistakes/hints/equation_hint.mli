(** Hints about equations and the statements of a `do`. *)

val split_by_value : Found.rule
(** `x<-1` where `<` and `-` are meant. *)

val outside_do : Found.rule
(** A statement outside of a `do`. *)

val outside_proc : Found.rule
(** A command outside of a `proc`. *)

val changed : Found.rule
(** [x += 1], and [x != 1]. *)

val in_a_choice : Found.rule
(** An equation after `then` or `else`. *)

val keyword_argument : Found.rule
(** [f (v = 1)]. *)

val changed_field : Found.rule
(** [r.speed = 1]. *)

val statement : Found.rule
(** An equation among the statements of a task. *)

val comparison : Found.rule
(** A `=` that compares. *)

val of_a_proc : Found.t -> bool
(** Is the enclosing `do` that of a `proc`, so that its statements are not tasks? *)
