(** Hints about operators, most of them other languages'. *)

val foreign : Found.rule
(** An operator of another language that starts with one of Frob. *)

val row : Found.rule
(** [m ! 0, 1], as in languages with indices of two numbers. *)

val member : Found.rule
(** [r->speed], as in C. *)

val negation : Found.rule
(** [!b]. *)

val before_point : Found.rule
(** [.5]. *)

val after_point : Found.rule
(** [5.]. *)

val comment : Found.rule
(** A comment that starts with a slash. *)

val own : Found.rule
(** An operator that starts with a bar. *)

val pipe : Found.rule
(** [x |> f]. *)

(** {1 For other hints} *)

val assigns : Found.t -> string option
(** The hint for a `=` directly after an operator, by that operator. *)

val starts_a_comment : Found.t -> bool
(** Is this a C-style comment at the start of a line? *)

val own_operator : string
(** The hint for the definition of an operator. *)
