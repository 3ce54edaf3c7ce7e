(** Converts a fragment to statements: decides where each value is computed.

    A value is computed in the innermost block that contains all its uses, before the first one.
    Values that only one branch needs are therefore computed in that branch. Choices with the same
    condition share an [If] if the order allows it. Items are placed from the last to the first,
    because then all uses of a value are placed before the value itself. Linear in the size of the
    fragment. *)

val nesting : int
(** Maximum nesting of blocks. A value that would be nested deeper is placed in the outermost block.
*)

val statements : Feedback.t -> Fragment.t -> Ir.statement list
