(** [textDocument/references] finds all occurrences of a symbol in the programs of the workspace
    folders; [documentHighlight] finds those in one text. *)

open Basis

val of_symbol :
  Workspace.t ->
  Document.t ->
  Json.t ->
  (Index.symbol * (Analysis.t * Index.occurrence) list) option
(** The symbol at the position given by these request parameters, and its occurrences, without
    duplicates. *)

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
val highlights : Workspace.t -> Document.t -> Json.t -> Json.t
