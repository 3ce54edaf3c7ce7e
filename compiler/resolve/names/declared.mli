(** The names that a module declares. *)

val program :
  Context.t -> module_:string -> ?after:Interface.names -> Syntax.Ir.program -> Interface.names
(** The names declared at a module's top level and, for the prelude, the built-in types and classes.
    Reports a name that is declared twice. [after]: for a test file, the names of its program; the
    result includes them, and the test file cannot declare them again. *)
