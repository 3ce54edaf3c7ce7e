(** Surface: the tree that the grammar builds on the way to {!Ir}.

    A pattern and an expression can begin with the same tokens, and only a later [=], [<-] or [->]
    distinguishes them. The grammar therefore parses both as a {!term}, which {!Term} converts to
    one or the other. *)

open Basis

type term = { desc : term_desc; span : Span.t }

and term_desc =
  | Expression of Ir.expr_desc  (** an expression that cannot be a pattern *)
  | Wildcard
  | As of Ir.name * term
  | Variable of Ir.qualified
  | Constructor of Ir.qualified
  | Number of Ir.number
  | Negated of term
  | Tuple of term list  (** empty, or at least two elements *)
  | Array of term list
  | Parenthesized of term
  | Application of { head : term; arguments : term list }  (** at least one argument *)
  | Braces of { before : term; fields : (Ir.name * term) list }
      (** record construction or pattern ([before] is a constructor), or a record update *)

(** A part of [a + - b * c] before the last operand: an operand with the operator that follows it,
    or a minus sign. *)
type step = Operand of { operand : term; operator : Ir.qualified } | Minus of Span.t

(** A statement of a [do] block, before {!Build} converts it. *)
type statement =
  | Arrow_bind of { left : term; right : Ir.expr }  (** [p <- e] *)
  | Command_bind of { left : term; command : Ir.command }  (** [p <- sf -< e] *)
  | Bare_command of Ir.command
  | Bare_expression of term
  | Let of Ir.declaration list
  | Rec of statement list

type factor = { factor : factor_desc; over : bool;  (** follows a [/] *) span : Span.t }
(** A factor of a unit, or of the right-hand side of a [unit] declaration. *)

and factor_desc = Amount of { digits : string; decimal : bool } | Measure of Ir.unit_

(** A top-level item. [Nothing] if there is no code between two separators. *)
type item = Header of Ir.header | Import of Ir.import | Declaration of Ir.declaration | Nothing
