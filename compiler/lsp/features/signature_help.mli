(** [textDocument/signatureHelp]: the type of the function whose arguments are being written, and
    which of them comes now. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
