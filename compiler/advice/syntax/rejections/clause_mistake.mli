(** Messages about functions defined by several clauses, as in Haskell. *)

open Basis
open Syntax.Rejection

val diagnostic : clause -> clause -> clause list -> Diagnostic.t
(** The message about a function that is defined by several clauses. The fix rewrites the clauses as
    a [case]. *)
