(** [textDocument/rename] and [prepareRename]: rename a symbol in all programs of the workspace
    folders. The request fails if renaming would change the meaning of any program or make it
    invalid. *)

open Basis

val prepare : Workspace.t -> Document.t -> Json.t -> Json.t
val answer : Workspace.t -> Document.t -> Json.t -> (Json.t, string) result
