(** Resolves the types and units that a module declares, in dependency order. *)

val types : Scope.t -> Syntax.Ir.program -> Ir.type_declaration list
(** Includes the built-in types if the module is the prelude. Reports a cyclic alias and a data type
    that contains itself. *)

val sort :
  name:('a -> string) -> uses:('a -> string list) -> report:('a list -> unit) -> 'a list -> 'a list
(** Sorts declarations of one module in dependency order. Calls [report] for each cycle. *)

val units : Scope.t -> Syntax.Ir.program -> Ir.unit_declaration list
(** Reports a unit defined in terms of itself, and a name that could be confused with a unit
    variable. *)
