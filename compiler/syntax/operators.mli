(** The fixed table of operator precedences (language reference, section 11). *)

val symbols : string list
(** Every operator symbol. The lexer takes the longest match. *)

val group : Surface.step list -> Surface.term -> Surface.term
(** [group steps last] groups [steps… last] by precedence and associativity. The steps are in
    reverse order. Takes linear time and does not use the call stack.
    @raise Reject.Rejected if the table does not define the grouping *)

val left_section :
  span:Basis.Span.t -> Surface.step list -> Surface.term -> Ir.qualified -> Surface.term
(** Groups the left section [(steps… operand operator)]. *)

val right_section :
  span:Basis.Span.t -> Ir.qualified -> Surface.step list -> Surface.term -> Surface.term
(** Groups the right section [(operator steps… last)]. *)

val groups_inside : outer:Ir.qualified -> side:[ `Left | `Right ] -> Ir.qualified -> bool
(** Can an application of this operator be an operand of [outer] on that side without parentheses?
*)
