(** Messages about input that is grammatical but has no meaning. *)

open Basis

val diagnostic : text:string -> Syntax.Rejection.t -> Diagnostic.t
(** [text]: the source. *)
