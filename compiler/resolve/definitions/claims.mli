(** Checks assertions and tests before names are resolved; see {!Labels}. *)

val check : Scope.t -> Syntax.Ir.program -> unit
(** Reports an assertion that is not among the equations of a proc, and a label that is not a single
    line of text. *)
