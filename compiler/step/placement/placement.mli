(** Where each value is computed: from a fragment to statements.

    A value gets the innermost block that holds all its uses, before the first of them; so what only
    one branch needs is computed there. Choices by the same condition share one [If] where the order
    allows it. Works from the last item to the first, as then all uses of a value are placed before
    the value itself. Linear in the size of the fragment. *)

val nesting : int
(** No block is nested deeper; a value that would be goes to the outermost. *)

val statements : Feedback.t -> Fragment.t -> Ir.statement list
