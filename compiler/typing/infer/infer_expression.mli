(** Infers expressions. *)

val expressions : Context.expressions
