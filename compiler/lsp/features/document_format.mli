(** [textDocument/formatting]: formats a program in the same way as [frobc format]. *)

open Basis

val edits : Workspace.t -> Document.t -> (Json.t, string) result
(** The list of edits is empty if the text is not a program. An error means that the formatter has a
    bug. *)
