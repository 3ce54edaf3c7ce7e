(** The fixed table of operators (language reference, section 11). *)

val symbols : string list
(** Every operator symbol, for the lexer's longest match. *)

val group : Surface.step list -> Surface.term -> Surface.term
(** [group steps last] is [steps… last] with every operator applied to its operands as the table
    says; the steps come last one first. Raises {!Reject.Rejected} where the table leaves the order
    open. Linear, and keeps no stack of its own calls. *)

val left_section :
  span:Basis.Span.t -> Surface.step list -> Surface.term -> Ir.qualified -> Surface.term
(** [(steps… operand operator)]. *)

val right_section :
  span:Basis.Span.t -> Ir.qualified -> Surface.step list -> Surface.term -> Surface.term
(** [(operator steps… last)]. *)

val groups_inside : outer:Ir.qualified -> side:[ `Left | `Right ] -> Ir.qualified -> bool
(** May this operator's application be an operand of [outer] on that side, without parentheses? *)
