(** [textDocument/definition]: where the name under the cursor is declared. *)

open Basis

val answer : Workspace.t -> Document.t -> Json.t -> Json.t

val symbol_at : Workspace.t -> Document.t -> Json.t -> (View.seen * Index.occurrence) option
(** That the position in these parameters is at. *)
