(** The names of a module that have no meaning. *)

open Basis

val diagnostics :
  Suggestion.t -> Resolve.Visible.t -> Resolve.Fact.unresolved list -> Diagnostic.t list
(** One diagnostic for each missing import, and one for each name with all its places. *)
