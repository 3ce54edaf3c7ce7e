(** What expressions and patterns are made of. *)

val exists : (Ir.expr -> bool) -> Ir.expr -> bool
(** Of the names and literals in it. *)

val is_static : Ir.ty -> bool
(** Of a function, a signal function, a task, or something with one in it: no signal of a proc has
    this type. *)

val variables : Ir.pattern -> Ir.Local.t list
(** Those that it binds, the last first. *)
