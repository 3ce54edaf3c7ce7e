(** [textDocument/foldingRange] and [selectionRange]: by indentation, so that a text need not be a
    program. *)

open Basis

val ranges : Document.t -> Json.t

val selections : Workspace.t -> Document.t -> Json.t -> Json.t
(** From the word at each position outwards: what is in brackets, the line, the block, the
    definition, the text; with expressions in between where the text is a program. *)
