(** Translates the facts that name resolution reports into diagnostics. *)

open Basis

val into : Diagnostic.sink -> Resolve.Fact.t Facts.t
(** Translates each fact into a diagnostic and emits it to the sink. *)
