(** Expressions: names looked up; operators and sections become applications and functions; every
    notation of a proc becomes equations and an output. *)

val expr : Env.t -> Syntax.Ir.expr -> Ir.expr

val command : Env.t -> Syntax.Ir.command -> Ir.expr
(** [sf -< e]: [e] is what [sf] runs on. *)
