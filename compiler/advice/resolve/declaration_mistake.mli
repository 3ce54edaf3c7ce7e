(** Messages about declarations of types, units, classes and instances, and about misused types. *)

open Basis

val diagnostic : Suggestion.t -> Resolve.Fact.in_types -> Diagnostic.t
