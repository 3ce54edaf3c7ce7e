(** [textDocument/formatting]: formats a program like [frobc format]. *)

open Basis

val edits : Workspace.t -> Document.t -> (Json.t, string) result
(** No edits if the text is not a program. An error means that the formatter has a bug. *)
