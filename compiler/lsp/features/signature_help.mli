(** [textDocument/signatureHelp]: shows the type of the function whose arguments are being typed,
    and which argument is next. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
