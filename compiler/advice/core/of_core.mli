(** Turns the facts of Core into diagnostics. *)

open Basis

val into : Diagnostic.sink -> Core.Fact.t Facts.t
(** Emits the diagnostics into the sink. *)
