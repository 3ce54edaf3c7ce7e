(** A resolved program as text, for dumps and tests: like Frob, but every name says what it is:
    [Module.name], or [name@id] for a local variable. *)

val program : Format.formatter -> Ir.program -> unit
(** The modules outside of the library; of the library only the names. *)

val ty : Format.formatter -> Ir.ty -> unit
val scheme : Format.formatter -> Ir.scheme -> unit
