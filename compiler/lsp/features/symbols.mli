(** [textDocument/documentSymbol] and [workspace/symbol]: what a text declares, and all programs of
    the folders. *)

open Basis

val of_document : Workspace.t -> Document.t -> Json.t

val of_workspace : Workspace.t -> string -> Json.t
(** Those with the letters of the query in this order. *)
