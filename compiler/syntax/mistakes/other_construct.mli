(** Constructs that Frob does not have, or that belong in another place: `deriving`, [x[0]], a `let`
    at the left edge and the like. These messages replace that of the automaton's state. *)

val diagnostic : Found.t -> Basis.Diagnostic.t option
(** E0110, or E0112 for a reserved word. *)
