(** Determines what a module exports and what an import brings into scope. *)

val of_module : Scope.t -> Syntax.Ir.header option -> Interface.names
(** The names listed in the header, including re-exported ones, or all names that the module
    declares. *)

val texts : Syntax.Ir.name list -> Interface.String_set.t

val imported :
  Context.t -> Syntax.Ir.import option -> module_:string -> Interface.names -> Visible.import
(** The part of a module's exports that an import brings into scope. [None] is the implicit import
    of the prelude. Reports a name that is not exported. *)

val idle : Scope.t -> Syntax.Ir.import option -> module_:string -> Interface.names -> Ir.idle list
(** The unused parts of an import in a resolved module. With an import list: the unused names in the
    list. Without one: the whole import, unless one of its names is used. *)
