(** Messages about the undefined names of a module. *)

open Basis

val diagnostics :
  Suggestion.t -> Resolve.Visible.t -> Resolve.Fact.unresolved list -> Diagnostic.t list
(** One diagnostic for each missing import, and one for each remaining name, with the places where
    that name occurs. *)
