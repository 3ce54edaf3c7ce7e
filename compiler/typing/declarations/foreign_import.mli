(** What the programmer imports from C, and what its type may be: C has numbers, truth, structs of
    them, and the foreign types themselves.

    A function takes at least one argument ([()] for none); a signal function has the type [SF a b]
    itself. Types have no variables, but of units, which C does not see. *)

val program :
  Basis.Diagnostic.sink ->
  Resolve.Ir.program ->
  environment:Environment.t ->
  primitives:(Ir.Global.t * Ir.scheme) list ->
  Ir.foreign
(** Emits E0380 for a type that C has not, E0381 for a C function that is imported with two types.
*)
