(** [textDocument/publishDiagnostics]: the compiler's messages. *)

open Basis

val parameters : Workspace.t -> Document.t -> Json.t
(** The parameters of the notification for the text that was checked last. *)

val of_diagnostic : Workspace.t -> Analysis.t -> Diagnostic.t -> Json.t

val none : string -> Json.t
(** Clears the messages of a text, given by its URI, that was closed. *)
