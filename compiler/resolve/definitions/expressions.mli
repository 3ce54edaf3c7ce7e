(** Resolves expressions: looks up names, turns operators and sections into applications and
    functions, and turns every proc notation into equations and an output. *)

val expr : Env.t -> Syntax.Ir.expr -> Ir.expr

val command : Env.t -> Syntax.Ir.command -> Ir.expr
(** Resolves a command, [sf -< e], which runs [sf] on [e]. *)
