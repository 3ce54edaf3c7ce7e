(** [textDocument/completion]: suggests names that fit the context of the cursor, such as fields
    after a record, units in brackets, modules after [import], and types in signatures. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t

val resolve : Workspace.t -> Json.t -> Json.t
(** [completionItem/resolve]: adds the type and the doc comment to an item. *)
