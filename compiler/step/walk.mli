(** Visiting all expressions of a function. *)

val children : Ir.expr -> Ir.expr list

val map_children : (Ir.expr -> Ir.expr) -> Ir.expr -> Ir.expr
(** The expression with other parts. *)

val expression : (Ir.expr -> unit) -> Ir.expr -> unit
(** It and each part of it, itself first. *)

val expressions : (Ir.expr -> unit) -> Ir.statement list -> unit
(** Each expression and each part of one, in the order of the code. *)

val statements : (Ir.statement -> unit) -> Ir.statement list -> unit
(** Each statement, an [If] before those inside it. *)

val entries : (Ir.entry -> unit) -> Ir.statement list -> unit
(** Each entry of a mode. *)

val map_statements :
  expression:(Ir.expr -> Ir.expr) ->
  entry:(Ir.entry -> Ir.entry) ->
  Ir.statement list ->
  Ir.statement list
(** The statements with other expressions, each given as a whole, and entries of modes,
    after the expressions in them. *)
