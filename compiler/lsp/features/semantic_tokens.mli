(** [textDocument/semanticTokens/full]: classifies each name, and says whether variables are
    signals, static or constant. *)

open Basis

val legend : Json.t
val answer : Workspace.t -> Document.t -> Json.t
