(** Warnings about a typed program. *)

val emit :
  Request.t ->
  Basis.Diagnostic.sink ->
  sources:Basis.Source.t ->
  resolved:Resolve.Ir.program ->
  Typing.Ir.program ->
  unit
(** Reports the warnings that are not reported by the compiler's stages themselves. The last two
    arguments are the same program before and after type checking. *)
