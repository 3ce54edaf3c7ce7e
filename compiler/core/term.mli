(** Core expressions by their construction: each with the type it must have. *)

open Basis

val make : Ir.ty -> Span.t -> Ir.expr_desc -> Ir.expr

val variable : Ir.binder -> Span.t -> Ir.expr
(** A use of a monomorphic variable. *)

val apply : Ir.expr -> Ir.expr -> Ir.ty -> Span.t -> Ir.expr
(** The type and the place are those of the result. *)

val not_ : Ir.expr -> Ir.expr

val conjunction : Ir.expr -> Ir.expr -> Ir.expr
(** The second only where the first holds, so it may take for granted what the first has tested. *)

val if_ : Ir.expr -> Ir.expr -> Ir.expr -> Span.t -> Ir.expr
(** Of a negation it exchanges the branches. *)

val equal : Ir.expr -> Ir.expr -> Ir.expr
(** By the primitive, at the type of the first. *)

val let_ : Ir.binder -> Ir.expr -> Ir.expr -> Ir.expr

val is_trivial : Ir.expr -> bool
(** As good twice as once: a variable, a constant, or the call of a nullary function; binds nothing.
*)

val parts : Ir.expr -> Ir.expr list
(** The expressions in it, in the order of the text; those of a proc's equations before its output.
*)

val with_parts : (Ir.expr -> Ir.expr) -> Ir.expr -> Ir.expr_desc
(** The expression with other {!parts}, made in their order. *)
