(** [textDocument/definition]: finds the declaration of the name under the cursor. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t

val symbol_at : Workspace.t -> Document.t -> Json.t -> (View.seen * Index.occurrence) option
(** The symbol at the position given by these request parameters. *)
