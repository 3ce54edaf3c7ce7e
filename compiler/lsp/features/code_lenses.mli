(** [textDocument/codeLens]: above the entry of a program, the costs of a step and a command that
    runs it in the simulator; above each test and trial, in programs and test files, a command that
    runs it. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t
