(** [textDocument/documentSymbol] and [workspace/symbol]: list the declarations of a text, or of all
    programs in the workspace folders. *)

open Basis

val of_document : Workspace.t -> Document.t -> Json.t

val of_workspace : Workspace.t -> string -> Json.t
(** The declarations whose names contain the letters of the query in the same order. *)
