(** Messages about declarations of foreign code whose names cannot be used in C. *)

open Basis

val diagnostic : Resolve.Fact.in_foreign_code -> Diagnostic.t
