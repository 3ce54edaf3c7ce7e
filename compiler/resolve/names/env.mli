(** What names mean inside of a definition: local variables, then the module's scope. *)

open Basis

type t

val top : Scope.t -> Groups.t -> int String_table.t -> t
(** No locals; the module's own definitions have these numbers in the group of its top level. *)

val of_module : Scope.t -> t
(** No locals, and nothing under analysis: for what stands outside of all groups. *)

val beside_procs : t -> Syntax.Ir.right -> t
(** In this right side, with the [proc]s in it; for messages about names that are signals of a
    [proc] elsewhere in the definition. *)

val scope : t -> Scope.t
val context : t -> Context.t

type owner = { group : Groups.t; index : int; signed : bool }
(** Where a local variable is defined: a binding of a group under analysis. *)

type variable = { local : Ir.Local.t; owner : owner option  (** none for parameters *) }

val bind : t -> variable list -> t
(** Adds variables that come into scope together. Emits E0212 if two have one name, W0201 if one
    hides a local variable. *)

val is_known : t -> Syntax.Ir.name -> bool

val variable : t -> Syntax.Ir.qualified -> Ir.expr_desc option
(** Notes the reference in the group of what it refers to. Emits a diagnostic if there is no such
    variable. *)

val global : t -> string -> Span.t -> Ir.expr_desc option
(** An operator or other name of module level, whatever the locals. *)
