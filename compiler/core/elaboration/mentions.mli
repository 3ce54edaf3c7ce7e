(** The variables that an expression of Typed mentions and does not bind. *)

type t = {
  variables : Ir.binder list;  (** each once, in order of the first mention *)
  runs : bool;  (** an instance of the proc around stands in it *)
}

val of_expr : Typing.Ir.expr -> t
