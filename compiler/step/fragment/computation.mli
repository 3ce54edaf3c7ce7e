(** Translates stateless equations to expressions, whose place in the code is chosen later. *)

open Fragment

val computed : Flow.Ir.equation -> Flow.Ir.rhs -> computed
(** Translates the equation with this right-hand side instead of its own. The right-hand side must
    be stateless (not a {!Flow.Ir.Delay}, for example). *)

val without_self_comparison : Flow.Ir.rhs -> Flow.Ir.rhs
(** Replaces comparisons of a signal with itself, because C compilers warn about them. Keeps
    [x == x], which tests for NaN. *)

val operation : span:Basis.Span.t -> Flow.Ir.operator -> Ir.ty -> Ir.expr list -> Ir.expr
val atom_type : Flow.Ir.atom -> Ir.ty

val one : Ir.expr list -> Ir.expr
(** The only element of the list. *)
