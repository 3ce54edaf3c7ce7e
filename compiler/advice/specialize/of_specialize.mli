(** Turns the facts of specialization into diagnostics. *)

open Basis

val into : Diagnostic.sink -> Specialize.Fact.t Facts.t
(** Emits the diagnostics into the sink. *)
