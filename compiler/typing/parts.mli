(** What expressions and patterns are made of. *)

val exists : (Ir.expr -> bool) -> Ir.expr -> bool
(** Of the names and literals in it. *)

val variables : Ir.pattern -> Ir.Local.t list
(** Those that it binds, the last first. *)
