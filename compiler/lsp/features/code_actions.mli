(** [textDocument/codeAction]: the fixes of the messages at a place, and a signature for a
    definition without one. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
