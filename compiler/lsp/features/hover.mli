(** [textDocument/hover]: shows the type with units, the level and the doc comment of a name. For
    other expressions, shows the type. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
