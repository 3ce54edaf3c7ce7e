(** [textDocument/foldingRange] and [selectionRange]. Both are based on indentation, so they also
    work for texts that are not programs. *)

open Basis

val ranges : Document.t -> Json.t

val selections : Workspace.t -> Document.t -> Json.t -> Json.t
(** For each position, ranges from the inside out: the word, the line, the top-level declaration and
    the text. If the text is a program, also the expressions around the position. *)
