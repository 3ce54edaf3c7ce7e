(** Hints about operators, most of which come from other languages. *)

open Basis

val foreign : Found.t -> Diagnostic.hint option
(** An operator from another language that starts with a Frob operator. *)

val row : Found.rule
(** [m ! 0, 1], an index consisting of two numbers. *)

val member : Found.rule
(** [r->speed], as in C. *)

val negation : Found.rule
(** [!b], as in C. *)

val negated : Found.t -> (string * int) option
(** The negation that {!negation} suggests, and the offset after its operand in the source. *)

val disjunction : Found.rule
(** [a | b], as in C. *)

val decimal_comma : Found.rule
(** [0,3], with a comma instead of a decimal point. *)

val before_point : Found.rule
(** [.5], without a digit before the decimal point. *)

val after_point : Found.rule
(** [5.], without a digit after the decimal point. *)

val comment : Found.rule
(** A comment that starts with a slash. *)

val own : Found.t -> Diagnostic.hint option
(** An operator that starts with a bar. *)

val pipe : Found.rule
(** [x |> f], as in OCaml. *)

(** {1 Functions used by other hints} *)

val rest_of_line : Found.t -> int -> string
(** The rest of the line after this offset, without a semicolon at its end. *)

val assigns : Found.t -> string option
(** The hint for an operator directly followed by `=`. *)

val starts_a_comment : Found.t -> bool
(** Is this a C-style comment at the start of a line? *)
