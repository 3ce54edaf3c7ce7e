(** Smart constructors for Core expressions, which compute the types. *)

open Basis

val make : Ir.ty -> Span.t -> Ir.expr_desc -> Ir.expr

val variable : Ir.binder -> Span.t -> Ir.expr
(** A use of a monomorphic variable. *)

val apply : Ir.expr -> Ir.expr -> Ir.ty -> Span.t -> Ir.expr
(** An application; the type and the span are those of the result. *)

val not_ : Ir.expr -> Ir.expr

val conjunction : Ir.expr -> Ir.expr -> Ir.expr
(** The second operand is evaluated only if the first is true, so it may rely on what the first has
    tested. *)

val if_ : Ir.expr -> Ir.expr -> Ir.expr -> Span.t -> Ir.expr
(** A conditional. If the condition is a negation, removes it and swaps the branches. *)

val equal : Ir.expr -> Ir.expr -> Ir.expr
(** Equality at the type of the first operand. *)

val let_ : Ir.binder -> Ir.expr -> Ir.expr -> Ir.expr

val is_trivial : Ir.expr -> bool
(** May the expression be duplicated? True for a variable, a constant, or the call of a nullary
    function. It binds no variables. *)

val parts : Ir.expr -> Ir.expr list
(** The direct subexpressions, in source order; a proc's equations come before its output. *)

val visit : (Ir.expr -> unit) -> Ir.expr -> unit
(** Visits an expression, then its subexpressions. *)

val with_parts : (Ir.expr -> Ir.expr) -> Ir.expr -> Ir.expr_desc
(** Replaces the {!parts} of the expression with their images, computed in order. *)
