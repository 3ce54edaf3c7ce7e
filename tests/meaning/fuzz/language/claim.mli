(** Random conditions for assertions, and for observers of tests. *)

val condition : Scope.t -> string
(** An expression of type [Bool] or [Verdict], in parentheses, about this instant or the past. *)
