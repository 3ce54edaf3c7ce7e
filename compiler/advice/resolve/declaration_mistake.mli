(** Messages about declarations of types, units, classes and instances, and about types that are
    used wrongly. *)

open Basis

val diagnostic : Suggestion.t -> Resolve.Fact.in_types -> Diagnostic.t
