(** Prints a resolved program for dumps and tests. The output resembles Frob, but every name is
    resolved: [Module.name] for globals, [name@line:column] for local variables. *)

val program : Format.formatter -> Ir.program -> unit
(** Prints the modules outside the library, and only the names of the library modules. *)

val ty : Format.formatter -> Ir.ty -> unit
val scheme : Format.formatter -> Ir.scheme -> unit
