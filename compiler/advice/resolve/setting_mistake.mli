(** Messages about parameters that are set on the command line. *)

open Basis

val diagnostic : name:string -> at:Span.t -> Resolve.Fact.setting -> Diagnostic.t
