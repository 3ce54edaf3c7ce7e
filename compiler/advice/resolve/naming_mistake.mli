(** Names that are ambiguous, defined twice or not defined, and misplaced definitions. *)

open Basis

val diagnostic : Suggestion.t -> Resolve.Fact.in_definitions -> Diagnostic.t
