(** [textDocument/publishDiagnostics]: the compiler's messages. *)

open Basis

val parameters : Workspace.t -> Document.t -> Json.t
(** The parameters of the notification, with the diagnostics from the last check of the text. *)

val of_diagnostic : Workspace.t -> Analysis.t -> Diagnostic.t -> Json.t

val none : string -> Json.t
(** The parameters that clear the messages of a closed text, given by its URI. *)
