(** Resolves patterns: looks up constructors and checks their arity, turns record patterns into
    positional ones, and creates the variables. *)

val pattern : Scope.t -> Syntax.Ir.pattern -> Ir.pattern

val variables : Ir.pattern -> Ir.Local.t list
(** The variables bound by a pattern, in source order. *)

val bind : Env.t -> Syntax.Ir.pattern list -> Env.t * Ir.pattern list
(** Resolves patterns whose variables come into scope together, such as the parameters of a
    function. *)

val number : Scope.t -> Syntax.Ir.number -> Ir.number

val construction :
  Scope.t ->
  Interface.constructor ->
  at:Basis.Span.t ->
  (Syntax.Ir.name * 'a) list ->
  (Syntax.Ir.name * 'a) list option
(** Checks the fields given for a constructor, and returns each valid field once; [None] if the
    constructor has no named fields. Reports an unknown or repeated field. *)
