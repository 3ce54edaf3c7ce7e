(** Lambda lifting: polymorphic local functions and recursive local definitions become top-level
    definitions.

    The variables that they capture become parameters, and each use passes them as arguments. Later
    stages therefore need not handle modes and tasks that are recursive within a [where]. *)

type table
(** The definitions lifted so far. *)

val table : unit -> table

type scope
(** The scope of an expression: the enclosing names and type variables, and the parameters that
    replace captured variables inside a lifted definition. *)

val scope : Ir.Global.t -> Ir.variable list -> scope
(** The scope of a top-level definition with these type parameters. *)

val variable : table -> scope -> Typing.Ir.expr -> Ir.Local.t -> Ir.ty list -> Ir.expr
(** Translates a use of a local variable at these types. *)

type lifted = {
  binding : Typing.Ir.binding;
  inside : scope;  (** the scope of its value *)
  name : Ir.Global.t;  (** a unique name, in a module named after the enclosing definition *)
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
(** Splits a list of bindings into those that are lifted and those that remain, both in order. A
    proc's equation can be lifted only if it does not define a signal. *)

val definition : lifted -> Ir.expr -> Ir.definition
(** The lifted definition, with its translated value. *)
