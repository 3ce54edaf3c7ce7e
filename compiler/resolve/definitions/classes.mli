(** Resolves the type classes and instances that a module declares. *)

val classes :
  Env.t ->
  expr:Syntax.Ir.expr Bindings.resolver ->
  command:Syntax.Ir.command Bindings.resolver ->
  Syntax.Ir.program ->
  Ir.class_ list
(** The classes, superclasses before subclasses. Emits E0229 for a class that is its own superclass,
    and E0230 for a definition that is not one of the class's methods. *)

val instances :
  Env.t ->
  expr:Syntax.Ir.expr Bindings.resolver ->
  command:Syntax.Ir.command Bindings.resolver ->
  Syntax.Ir.program ->
  Ir.instance list
(** The instances, in source order. Emits E0230 for a definition that is not one of the class's
    methods, and E0231 for a signature. *)
