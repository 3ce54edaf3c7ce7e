(** [textDocument/inlayHint]: shows the type after the name of each definition and equation without
    a signature, and whether it is static or constant. Disabled unless the setting [inlayHints] is
    on. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
