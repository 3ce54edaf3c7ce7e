(** Messages about names that are ambiguous, undefined or defined twice, and about misplaced
    definitions. *)

open Basis

val diagnostic : Suggestion.t -> Resolve.Fact.in_definitions -> Diagnostic.t
