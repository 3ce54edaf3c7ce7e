(** [textDocument/hover]: type with units, level and doc comment of a name; of any other expression
    its type. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t
