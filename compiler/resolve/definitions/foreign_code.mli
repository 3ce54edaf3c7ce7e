(** Checks the strings in [foreign] declarations, which are copied into generated C. Each string
    must be valid C syntax at the place where it is inserted. *)

val check_symbol : Scope.t -> kind:Syntax.Ir.foreign_kind -> Syntax.Ir.name -> unit
(** Checks the name of a function or the prefix of a component's names. It must be a C identifier
    that C does not already use. *)

val check_type : Scope.t -> Syntax.Ir.name -> unit
(** Checks a C type name, which may follow [struct], [union] or [enum]. *)

val check_includes : Scope.t -> Syntax.Ir.program -> unit
(** Reports a module that declares a copyable foreign type or a foreign signal function but does not
    include a header. A C compiler must know the size of everything that a program keeps in its
    state. *)

val check_header : Scope.t -> Syntax.Ir.name -> unit
(** Checks the path of a header, which must be inside the module's folder. *)
