(** Checks assertions and tests before names are resolved; see {!Labels}. *)

val check : Scope.t -> Syntax.Ir.program -> unit
(** Emits E0234 for an assertion that is not among the equations of a proc, and E0235 for a label
    that is not a single line of text. *)
