(** [textDocument/completion]: names that fit where the cursor is; fields behind a record, units in
    brackets, modules behind [import], types in signatures. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t

val resolve : Workspace.t -> Json.t -> Json.t
(** [completionItem/resolve]: the item with its type and its doc comment. *)
