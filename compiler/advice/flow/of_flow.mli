(** Turns the facts of Flow into diagnostics. *)

open Basis

val into : ?sources:Source.t -> Diagnostic.sink -> Flow.Fact.t Facts.t
(** Emits the diagnostics into the sink. Hints and fixes quote the sources. *)
