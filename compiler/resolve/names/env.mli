(** Looks up names inside a definition, first among local variables, then in the module's scope. *)

open Basis

type t

val top : Scope.t -> Groups.t -> int String_table.t -> t
(** The environment of a module's top level, without local variables. The table maps the module's
    own definitions to their numbers in the dependency analysis. *)

val of_module : Scope.t -> t
(** An environment without local variables and without dependency analysis, for code outside all
    groups. *)

val inside : t -> Syntax.Ir.right -> t
(** The environment of a right-hand side. Facts about undefined names contain this right-hand side,
    because such a name may be a signal of a [proc] elsewhere in the definition. *)

val with_sizes : t -> Sizes.t list -> t
(** The environment inside a definition whose signature has these size variables. They are used only
    in messages. *)

val scope : t -> Scope.t
val context : t -> Context.t

type owner = { group : Groups.t; index : int; signed : bool }
(** The definition of a local variable: its index in the dependency analysis, and whether it has a
    signature. *)

type variable = {
  local : Ir.Local.t;
  owner : owner option;  (** [None] for a variable without a definition, such as a parameter *)
}

val bind : t -> variable list -> t
(** Adds variables that come into scope together. Reports two with the same name, and warns if one
    hides a local variable. *)

val is_known : t -> Syntax.Ir.name -> bool

val variable : t -> Syntax.Ir.qualified -> Ir.expr_desc option
(** Looks up a variable, and records the reference in the dependency analysis. Reports a variable
    that does not exist. *)
