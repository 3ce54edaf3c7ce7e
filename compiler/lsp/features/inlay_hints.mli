(** [textDocument/inlayHint]: behind the name of each definition and equation without a signature
    its type, and that it is static or constant where it is no signal. Off until the setting
    [inlayHints] is on. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
