(** Functions defined by several clauses, as in Haskell. *)

open Basis
open Syntax.Rejection

val diagnostic : clause -> clause -> clause list -> Diagnostic.t
(** With a fix that writes the [case]. *)
