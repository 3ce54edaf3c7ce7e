(** The types and units that a module declares, each after what it uses. *)

val types : Scope.t -> Syntax.Ir.program -> Ir.type_declaration list
(** With the built-in ones if this is the prelude. Emits E0217 for an alias that stands for itself,
    E0218 for data that contains itself. *)

val sort :
  name:('a -> string) -> uses:('a -> string list) -> report:('a list -> unit) -> 'a list -> 'a list
(** Declarations of one module, each after those that it uses; [report] gets each circle. *)

val units : Scope.t -> Syntax.Ir.program -> Ir.unit_declaration list
(** Emits E0219 for a unit defined by itself, E0220 for a name that could be taken for a unit
    variable. *)
