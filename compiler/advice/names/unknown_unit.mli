(** Messages about undefined units. *)

open Basis

val diagnostic : Unknown.t -> Diagnostic.t option
(** The error with a hint that applies only to units. If there is no such hint, [None], and the
    rules for all names apply. *)

val of_variable : Resolve.Visible.t -> Syntax.Ir.name -> Diagnostic.t
(** A unit variable where only a unit is allowed. *)
