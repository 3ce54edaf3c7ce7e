(** Names of units without a meaning. *)

open Basis

val diagnostic : Unknown.t -> Diagnostic.t option
(** With a hint that only a unit can have. Otherwise, the rules for all names apply. *)

val of_variable : Resolve.Visible.t -> Syntax.Ir.name -> Diagnostic.t
(** A unit variable where only a unit is allowed. *)
