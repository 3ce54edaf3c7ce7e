(** Translates the facts that specialization reports into diagnostics. *)

open Basis

val into : Diagnostic.sink -> Specialize.Fact.t Facts.t
(** Translates each fact into a diagnostic and emits it to the sink. *)
