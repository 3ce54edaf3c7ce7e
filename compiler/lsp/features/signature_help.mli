(** [textDocument/signatureHelp]: shows the type of the function whose arguments the user is
    entering, and which argument is next. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
