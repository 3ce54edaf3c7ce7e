(** Smart constructors for Core expressions, which compute the types. *)

open Basis

val make : Ir.ty -> Span.t -> Ir.expr_desc -> Ir.expr

val variable : Ir.binder -> Span.t -> Ir.expr
(** A use of a monomorphic variable. *)

val apply : Ir.expr -> Ir.expr -> Ir.ty -> Span.t -> Ir.expr
(** An application; the type and the span are those of the result. *)

val not_ : Ir.expr -> Ir.expr

val conjunction : Ir.expr -> Ir.expr -> Ir.expr
(** The second operand is evaluated only if the first is true, so it may assume that the first is
    true. *)

val if_ : Ir.expr -> Ir.expr -> Ir.expr -> Span.t -> Ir.expr
(** A conditional. If the condition is a negation, removes the negation and swaps the branches. *)

val equal : Ir.expr -> Ir.expr -> Ir.expr
(** Equality at the type of the first operand. *)

val let_ : Ir.binder -> Ir.expr -> Ir.expr -> Ir.expr

val is_trivial : Ir.expr -> bool
(** Whether the expression may be duplicated: true for a variable, a constant, or a call of a
    nullary function. Such an expression binds no variables. *)

val parts : Ir.expr -> Ir.expr list
(** The direct subexpressions, in source order; a proc's equations come before its output. *)

val visit : (Ir.expr -> unit) -> Ir.expr -> unit
(** Visits an expression, then its subexpressions. *)

val with_parts : (Ir.expr -> Ir.expr) -> Ir.expr -> Ir.expr_desc
(** Applies the function to each of the {!parts} of the expression, in order, and replaces the part
    with the result. *)
