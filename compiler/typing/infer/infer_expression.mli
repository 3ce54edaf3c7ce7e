(** Expressions. *)

val expressions : Context.expressions
