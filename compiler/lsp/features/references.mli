(** [textDocument/references] and [documentHighlight]: all places of a symbol, in the programs of
    the folders. *)

open Basis

val of_symbol :
  Workspace.t ->
  Document.t ->
  Json.t ->
  (Index.symbol * (Analysis.t * Index.occurrence) list) option
(** The symbol at the position of these parameters, and where it stands, each place once. *)

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
val highlights : Workspace.t -> Document.t -> Json.t -> Json.t
