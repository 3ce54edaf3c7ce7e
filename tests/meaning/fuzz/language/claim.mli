(** Random conditions, as are asserted, and as observers say of a test. *)

val condition : Scope.t -> string
(** A [Bool] or a [Verdict], in parentheses: of this instant, or of the past. *)
