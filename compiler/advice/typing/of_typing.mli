(** Translates the type checker's facts into diagnostics. *)

open Basis

val into : ?sources:Source.t -> Diagnostic.sink -> Typing.Fact.t Facts.t
(** Translates each fact into a diagnostic and emits it to the sink. Hints and fixes quote the
    sources. *)
