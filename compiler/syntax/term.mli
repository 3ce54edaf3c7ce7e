(** Converts terms to expressions, patterns, or the left-hand side of a definition.

    All functions raise {!Reject.Rejected} if the term cannot be converted. Their recursion depth is
    bounded by the nesting of brackets, which {!Layout} limits. *)

val to_expr : Surface.term -> Ir.expr
val to_pattern : Surface.term -> Ir.pattern

val to_left : Surface.term -> Ir.left
(** Converts the left-hand side of a definition, before [=] or a guard. *)
