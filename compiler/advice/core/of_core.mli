(** Translates Core's facts into diagnostics. *)

open Basis

val into : Diagnostic.sink -> Core.Fact.t Facts.t
(** Translates each fact into a diagnostic and emits it to the sink. *)
