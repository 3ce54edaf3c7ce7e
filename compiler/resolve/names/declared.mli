(** The names that a module declares. *)

val program :
  Context.t -> module_:string -> ?after:Interface.names -> Syntax.Ir.program -> Interface.names
(** The names declared at a module's top level; the prelude's include the built-in types and
    classes. Reports a name that is declared twice. [after]: for a test file, the names of its
    program; they are included in the result and count as declared. *)
