(** [textDocument/publishDiagnostics]: what the compiler says, as it says it. *)

open Basis

val parameters : Workspace.t -> Document.t -> Json.t
(** Of the notification, for the text that was looked at last. *)

val of_diagnostic : Workspace.t -> Analysis.t -> Diagnostic.t -> Json.t

val none : string -> Json.t
(** For a text that is closed, by its URI. *)
