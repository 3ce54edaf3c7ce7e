(** [textDocument/formatting]: as [frobc format] writes a program. *)

open Basis

val edits : Workspace.t -> Document.t -> (Json.t, string) result
(** None if the text is no program; the error is the formatter's own fault. *)
