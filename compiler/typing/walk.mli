(** The parts of typed trees, for what looks at all of them. *)

val parts : (Ir.expr -> unit) -> Ir.expr -> unit
(** What stands directly in an expression, in the order written. *)

val own : Resolve.Ir.program -> (Ir.expr -> unit) -> Ir.program -> unit
(** The definitions of the modules that are not of the library. *)
