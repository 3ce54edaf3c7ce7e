(** Turns the facts of typing into diagnostics. *)

open Basis

val into : ?sources:Source.t -> Diagnostic.sink -> Typing.Fact.t Facts.t
(** Emits the diagnostics into the sink. Hints and fixes quote the sources. *)
