(** Lists of declarations: [let], [where], the equations of a proc. All bindings of a list are
    visible in all of its right sides. *)

type 'a resolver = Env.t -> 'a -> Ir.expr
(** How the expressions inside are resolved: bindings and expressions contain each other. *)

(** A binding's right side. *)
type right =
  | Definition of Syntax.Ir.right
  | Run of Syntax.Ir.command  (** the statement [p <- sf -< e] *)
  | Judged of Syntax.Ir.expr  (** what an assertion says *)

type item = { left : Syntax.Ir.left; right : right; doc : string option; span : Basis.Span.t }

val items : Syntax.Ir.declaration list -> item list
(** The bindings among declarations; [doc] may be that of the signature. *)

val equations : Syntax.Ir.declaration list -> item list
(** Those of a proc: the assertions among them too, each an equation of a name that no source can
    mention; see {!Labels}. *)

val signatures : Syntax.Ir.declaration list -> (Syntax.Ir.name * Syntax.Ir.qualified_type) list
(** The signatures among them, one entry for each name. *)

val declarations :
  Env.t ->
  expr:Syntax.Ir.expr resolver ->
  command:Syntax.Ir.command resolver ->
  items:item list ->
  signatures:(Syntax.Ir.name * Syntax.Ir.qualified_type) list ->
  Env.t * Ir.declarations
(** The environment is that of what follows, such as the body of a [let]. Emits E0212 for a name
    bound twice, E0214 for a signature without a binding. *)

val top_level :
  Scope.t ->
  expr:Syntax.Ir.expr resolver ->
  command:Syntax.Ir.command resolver ->
  Syntax.Ir.declaration list ->
  Ir.binding_group list
(** Likewise for the declarations of a module. *)

val binding :
  Env.t ->
  expr:Syntax.Ir.expr resolver ->
  command:Syntax.Ir.command resolver ->
  name:Ir.binder ->
  signature:Ir.scheme option ->
  item ->
  Ir.binding

val report_operator : Scope.t -> Syntax.Ir.name -> unit
(** E0227: programs define none. *)

val right :
  Env.t ->
  expr:Syntax.Ir.expr resolver ->
  command:Syntax.Ir.command resolver ->
  Syntax.Ir.right ->
  Ir.right

val guarded :
  Env.t ->
  expr:Syntax.Ir.expr resolver ->
  command:Syntax.Ir.command resolver ->
  guards:(Syntax.Ir.expr option * Syntax.Ir.expr) list ->
  where:Syntax.Ir.declaration list ->
  Ir.right
(** Alternatives under the [where] that they share. *)
