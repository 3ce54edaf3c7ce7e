(** Turns the facts of name resolution into diagnostics. *)

open Basis

val into : Diagnostic.sink -> Resolve.Fact.t Facts.t
(** Emits the diagnostics into the sink. *)
