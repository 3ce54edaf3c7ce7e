(** What an equation without memory computes, as an expression to be placed. *)

open Fragment

val computed : Flow.Ir.equation -> Flow.Ir.rhs -> computed
(** The equation with this right side in place of its own, which has no {!Flow.Ir.Delay} and the
    like. *)

val without_self_comparison : Flow.Ir.rhs -> Flow.Ir.rhs
(** C compilers warn of a comparison of something with itself; but [x == x] asks whether [x] is a
    number, and stays. *)

val operation : Flow.Ir.operator -> Ir.ty -> Ir.expr list -> Ir.expr
val atom_type : Flow.Ir.atom -> Ir.ty

val one : Ir.expr list -> Ir.expr
(** Of a list of one. *)
