(** The texts in [foreign] declarations, which C compilers will read: each must be what C has in its
    place (E0232). *)

val check_symbol : Scope.t -> kind:Syntax.Ir.foreign_kind -> Syntax.Ir.name -> unit
(** The name of a function, or what the names of a component begin with; none that C has already. *)

val check_type : Scope.t -> Syntax.Ir.name -> unit
(** A name, or [struct], [union] or [enum] and a name. *)

val check_includes : Scope.t -> Syntax.Ir.program -> unit
(** What programs keep in their own state must be known to C by its size: a module with such
    declarations has a header (E0233). *)

val check_header : Scope.t -> Syntax.Ir.name -> unit
(** The path of a header, not outside of the module's folder. *)
