(** Resolves lists of declarations: [let], [where], and the equations of a proc. All bindings of a
    list are visible in all of its right-hand sides. *)

type 'a resolver = Env.t -> 'a -> Ir.expr
(** The function that resolves expressions. It is passed as an argument because bindings and
    expressions contain each other. *)

(** The right-hand side of a binding. *)
type right =
  | Definition of Syntax.Ir.right
  | Run of Syntax.Ir.command  (** the statement [p <- sf -< e] *)
  | Judged of Syntax.Ir.expr  (** the condition of an assertion *)

type item = { left : Syntax.Ir.left; right : right; doc : string option; span : Basis.Span.t }

val items : Syntax.Ir.declaration list -> item list
(** The bindings in a list of declarations. [doc] may come from the signature. *)

val equations : Syntax.Ir.declaration list -> item list
(** The equations of a proc. Each of its assertions also becomes an equation, with a name that
    cannot occur in source code; see {!Labels}. *)

val signatures : Syntax.Ir.declaration list -> (Syntax.Ir.name * Syntax.Ir.qualified_type) list
(** The signatures in a list of declarations, one entry for each name. *)

val declarations :
  Env.t ->
  expr:Syntax.Ir.expr resolver ->
  command:Syntax.Ir.command resolver ->
  items:item list ->
  signatures:(Syntax.Ir.name * Syntax.Ir.qualified_type) list ->
  Env.t * Ir.declarations
(** Returns the environment for the code that follows, such as the body of a [let]. Reports a name
    bound twice and a signature without a binding. *)

val top_level :
  Scope.t ->
  expr:Syntax.Ir.expr resolver ->
  command:Syntax.Ir.command resolver ->
  Syntax.Ir.declaration list ->
  Ir.binding_group list
(** Like {!declarations}, for the declarations of a module. *)

val binding :
  Env.t ->
  expr:Syntax.Ir.expr resolver ->
  command:Syntax.Ir.command resolver ->
  name:Ir.binder ->
  signature:Ir.scheme option ->
  item ->
  Ir.binding

val report_operator : Scope.t -> Syntax.Ir.name -> unit
(** Reports that programs cannot define operators. *)

val guarded :
  Env.t ->
  expr:Syntax.Ir.expr resolver ->
  command:Syntax.Ir.command resolver ->
  guards:(Syntax.Ir.expr option * Syntax.Ir.expr) list ->
  where:Syntax.Ir.declaration list ->
  Ir.right
(** Resolves guarded alternatives and the [where] that they share. *)
