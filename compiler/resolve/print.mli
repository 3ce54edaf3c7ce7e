(** Prints a resolved program for dumps and tests. The output resembles Frob, but shows what every
    name refers to: [Module.name] is a global name, and [name@line:column] is a local variable. *)

val program : Format.formatter -> Ir.program -> unit
(** Prints the modules outside the library in full, but only the names of the library modules. *)
