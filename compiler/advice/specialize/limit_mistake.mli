(** Messages about programs that are too large to compile ([E0413]), or whose values contain too
    many numbers or too many levels of nested data ([E0316]). *)

open Basis

val diagnostic : Specialize.Limit_fact.t -> Diagnostic.t
