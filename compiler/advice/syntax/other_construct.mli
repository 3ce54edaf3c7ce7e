(** Constructs that Frob does not have, or that belong elsewhere: `deriving`, [x[0]], a `let` at the
    left margin and similar constructs. These messages replace the messages of the automaton's
    states. *)

val diagnostic : Found.t -> Basis.Diagnostic.t option
(** The error E0110, or E0112 for a reserved word. *)
