(** Lambda lifting: local functions that are polymorphic, and local definitions that use themselves,
    become definitions of the program. What they mention of the definition around becomes
    parameters, and is given wherever they are used.

    So nothing after Core has to know that modes and tasks may loop in a [where]. *)

type table
(** What has been lifted so far. *)

val table : unit -> table

type scope
(** Where an expression stands: the names and type variables around it, and by what parameters the
    variables are known that a lifted definition captured. *)

val scope : Ir.Global.t -> Ir.variable list -> scope
(** In a definition of the program, with these type parameters. *)

val variable : table -> scope -> Typing.Ir.expr -> Ir.Local.t -> Ir.ty list -> Ir.expr
(** What a use of a local variable becomes, at these types. *)

type lifted = {
  binding : Typing.Ir.binding;
  inside : scope;  (** of its value *)
  name : Ir.Global.t;  (** its own name, in a module named for what is around it *)
  types : Ir.variable list;
  parameters : Ir.binder list;
}

val choose :
  table ->
  Context.t ->
  scope ->
  at_every_instant:bool ->
  Typing.Ir.binding list ->
  lifted list * Typing.Ir.binding list
(** Of the bindings of one list those that are lifted, and those that stay, in order. Of equations
    of a proc only those can be lifted that are no signals. *)

val definition : lifted -> Ir.expr -> Ir.definition
(** Given its translated value. *)
