(** Checks the types of foreign imports. C has numbers, truth values, structs of them, and the
    foreign types themselves.

    A function takes at least one argument ([()] if it needs none). A signal function has the type
    [SF a b] itself. The types have no variables other than unit variables, which do not exist in C.
*)

val program :
  Basis.Diagnostic.sink ->
  Resolve.Ir.program ->
  environment:Environment.t ->
  primitives:(Ir.Global.t * Ir.scheme) list ->
  Ir.foreign
(** Emits E0380 for a type that has no counterpart in C, and E0381 for a C function imported with
    two different types. *)
