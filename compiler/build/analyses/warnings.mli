(** Warnings about a typed program. *)

val emit :
  Request.t -> Basis.Diagnostic.sink -> resolved:Resolve.Ir.program -> Typing.Ir.program -> unit
(** Reports the warnings that no stage reports itself. The arguments are the same program before and
    after type checking. *)
