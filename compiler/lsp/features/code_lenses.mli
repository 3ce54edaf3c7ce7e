(** [textDocument/codeLens]: above the entry of a program what a step of it needs, and to run it in
    the simulator. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t
