(** Converts a fragment to statements: decides where each value is computed.

    Each value is computed in the innermost block that contains all its uses, before the first use.
    Therefore values that only one branch needs are computed in that branch. Choices with the same
    condition share an [If] if the order allows it. Items are placed from the last to the first, so
    that all uses of a value are placed before the value itself. Takes time linear in the size of
    the fragment. *)

val nesting : int
(** Maximum nesting of blocks. A value that would be nested deeper is placed in the outermost block.
*)

val statements : Feedback.t -> Fragment.t -> Ir.statement list
