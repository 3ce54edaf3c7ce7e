(** Warnings about a typed program. *)

val emit :
  Request.t -> Basis.Diagnostic.sink -> resolved:Resolve.Ir.program -> Typing.Ir.program -> unit
(** Reports the warnings that are not reported by the compiler's stages themselves. The arguments
    are the same program before and after type checking. *)
