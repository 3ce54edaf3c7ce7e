(** What a module gives to those that import it, and what an import takes. *)

val of_module : Scope.t -> Syntax.Ir.header option -> Interface.names
(** All that it declares, or what its header lists, imported names included. *)

val texts : Syntax.Ir.name list -> Interface.String_set.t

val imported :
  Context.t -> Syntax.Ir.import option -> module_:string -> Interface.names -> Scope.import
(** The part of a module's exports that an import takes; [None] is the prelude's unwritten import.
    Emits E0215 for a name that is not exported. *)

val idle : Scope.t -> Syntax.Ir.import option -> module_:string -> Interface.names -> Ir.idle list
(** Of a module's import of these names, when the whole module has been resolved: the names of its
    list that the module does not use; without a list, the import if nothing of it is used. *)
