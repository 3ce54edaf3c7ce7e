(** [textDocument/codeAction]: offers fixes for the messages at a place, a type signature for a
    definition without one, and a refactoring that lifts a local definition to the top level. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
