(** Messages about constructors with wrong fields or arguments. *)

open Basis

val diagnostic : Suggestion.t -> Resolve.Fact.in_records -> Diagnostic.t
