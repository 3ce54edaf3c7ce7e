(** Visiting all expressions of a function. *)

val children : Ir.expr -> Ir.expr list

val expression : (Ir.expr -> unit) -> Ir.expr -> unit
(** It and each part of it, itself first. *)

val expressions : (Ir.expr -> unit) -> Ir.statement list -> unit
(** Each expression and each part of one, in the order of the code. *)

val statements : (Ir.statement -> unit) -> Ir.statement list -> unit
(** Each statement, an [If] before those inside it. *)
