(** The parts, units and source text of formulas, for hints that suggest a different formula. *)

open Basis
open Typing

val binary : Resolve.Ir.expr -> (string * Resolve.Ir.expr * Resolve.Ir.expr) option
(** The operator and the operands of an expression such as [a + b]. *)

val unit_of : Wording.t -> Resolve.Ir.expr -> Units.t option
(** The unit of the value, if it follows from written units, declared types and the types of local
    variables. *)

val factors : Resolve.Ir.expr -> (Resolve.Ir.expr * int) list
(** The factors of a product, each with its exponent, 1 or -1. *)

val is_square : Wording.t -> Resolve.Ir.expr -> bool
(** Is the value a square, a sum or difference of squares, or one of these multiplied by a number?
*)

val is_product : Wording.t -> Resolve.Ir.expr -> bool
(** Is the expression a product or quotient whose operands are variables and applications, not
    numbers? *)

val text : Wording.t -> Resolve.Ir.expr -> string option

val grouped : Wording.t -> Resolve.Ir.expr -> string option
(** The text with parentheses if it needs them as an argument. *)

val as_factor : Wording.t -> Resolve.Ir.expr -> string option
(** The text with parentheses if it needs them as a factor of a product. *)

val with_parts : Wording.t -> Resolve.Ir.expr -> (Span.t * string) list -> string option
(** The text of the expression with these strings in place of the parts, which must not overlap. *)

val with_part : Wording.t -> Resolve.Ir.expr -> part:Span.t -> string -> string option
(** The text of the expression with another text in place of one part. *)
