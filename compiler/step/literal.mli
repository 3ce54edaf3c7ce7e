(** Expressions that are constants, for passes that put in what they know. *)

val is : Ir.expr -> bool
(** A Bool, an Int, a Float, or no time. *)

val same : Ir.expr -> Ir.expr -> bool
(** The same constant, Floats bit for bit, or the same variable. *)

val operation : Basis.Real.t -> Flow.Ir.operator -> Ir.ty -> Ir.expr list -> Ir.expr
(** The operation on operands of which some may be constants by now: what it comes to,
    as far as that is plain. *)
