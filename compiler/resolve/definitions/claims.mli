(** What is wrong with assertions and tests before names are known; see {!Labels}. *)

val check : Scope.t -> Syntax.Ir.program -> unit
(** Emits E0234 for an assertion that stands elsewhere than among the equations of a proc, E0235 for
    a label that is no line of text. *)
