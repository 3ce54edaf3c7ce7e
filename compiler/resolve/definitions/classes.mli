(** The type classes and instances that a module declares. *)

val classes :
  Env.t ->
  expr:Syntax.Ir.expr Bindings.resolver ->
  command:Syntax.Ir.command Bindings.resolver ->
  Syntax.Ir.program ->
  Ir.class_ list
(** Each after its superclasses. Emits E0229 for a class that is its own superclass, E0230 for a
    definition of what is no method. *)

val instances :
  Env.t ->
  expr:Syntax.Ir.expr Bindings.resolver ->
  command:Syntax.Ir.command Bindings.resolver ->
  Syntax.Ir.program ->
  Ir.instance list
(** In source order. Emits E0230 likewise, E0231 for a signature. *)
