(** Terms become expressions, patterns, or the left side of a definition.

    All raise {!Reject.Rejected} where a term cannot be that. They call themselves only as deep as
    brackets are nested, which {!Layout} limits. *)

val to_expr : Surface.term -> Ir.expr
val to_pattern : Surface.term -> Ir.pattern

val to_left : Surface.term -> Ir.left
(** What stands before [=] (or before a guard). *)
