(** [textDocument/codeLens]: above [main], shows the costs of a step and a command that runs the
    program in the simulator; above each test and trial, in programs and test files, shows a command
    that runs it. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t
