(** Patterns: constructors looked up and their arguments counted, records made positional, variables
    fresh. *)

val pattern : Scope.t -> Syntax.Ir.pattern -> Ir.pattern

val variables : Ir.pattern -> Ir.Local.t list
(** In source order. *)

val bind : Env.t -> Syntax.Ir.pattern list -> Env.t * Ir.pattern list
(** Patterns whose variables come into scope together, as a function's parameters. *)

val number : Scope.t -> Syntax.Ir.number -> Ir.number

val construction :
  Scope.t ->
  Interface.constructor ->
  at:Basis.Span.t ->
  (Syntax.Ir.name * 'a) list ->
  (Syntax.Ir.name * 'a) list option
(** The given fields, each once and each a field of the constructor; [None] if it has no named
    fields. Emits E0209 for others, E0213 for repeated ones. *)
