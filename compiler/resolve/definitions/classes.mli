(** Resolves the type classes and instances that a module declares. *)

val classes :
  Env.t ->
  expr:Syntax.Ir.expr Bindings.resolver ->
  command:Syntax.Ir.command Bindings.resolver ->
  Syntax.Ir.program ->
  Ir.class_ list
(** The classes, superclasses before subclasses. Reports a class that is its own superclass, and a
    definition of a name that is not a method of the class. *)

val instances :
  Env.t ->
  expr:Syntax.Ir.expr Bindings.resolver ->
  command:Syntax.Ir.command Bindings.resolver ->
  Syntax.Ir.program ->
  Ir.instance list
(** The instances, in source order. Reports signatures, and definitions of names that are not
    methods of the class. *)
