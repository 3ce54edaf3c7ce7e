(** Checks the texts in [foreign] declarations, which are copied to generated C. Each text must have
    the C syntax that is required at its place. *)

val check_symbol : Scope.t -> kind:Syntax.Ir.foreign_kind -> Syntax.Ir.name -> unit
(** The name of a function, or the prefix of a component's names. It must not be a name that C
    already uses. *)

val check_type : Scope.t -> Syntax.Ir.name -> unit
(** A C type name, optionally after [struct], [union] or [enum]. *)

val check_includes : Scope.t -> Syntax.Ir.program -> unit
(** A C compiler must know the size of everything that a program keeps in its state. Therefore a
    module that declares a copyable foreign type or a foreign signal function must include a header.
*)

val check_header : Scope.t -> Syntax.Ir.name -> unit
(** The path of a header inside the module's folder. *)
