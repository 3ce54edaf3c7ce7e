(** Checks the types of foreign imports.

    C can represent numbers, Booleans, structs of them, and foreign types. A foreign function takes
    at least one argument ([()] if it does not need any). A foreign signal function has a type of
    the form [SF a b]. The types may contain unit variables, which do not exist in C, but no other
    variables. *)

val program :
  report:(Declaration_fact.t -> unit) ->
  Resolve.Ir.program ->
  environment:Environment.t ->
  primitives:(Ir.Global.t * Ir.scheme) list ->
  Ir.foreign
(** Reports types that have no counterpart in C, and C functions imported with two different types.
*)
