(** Messages about input that matches the grammar but is not valid. *)

open Basis

val diagnostic : text:string -> Syntax.Rejection.t -> Diagnostic.t
(** [text] is the source text. *)
