(** [textDocument/rename] and [prepareRename]: another name for a symbol, in all programs of the
    folders; refused if any of them would mean something else, or nothing. *)

open Basis

val prepare : Workspace.t -> Document.t -> Json.t -> Json.t
val answer : Workspace.t -> Document.t -> Json.t -> (Json.t, string) result
