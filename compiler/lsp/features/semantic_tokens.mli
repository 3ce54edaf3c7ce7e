(** [textDocument/semanticTokens/full]: what each name is, and of variables whether they are
    signals, static or constant. *)

open Basis

val legend : Json.t
val answer : Workspace.t -> Document.t -> Json.t
