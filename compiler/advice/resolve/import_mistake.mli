(** Messages about modules that are missing, unreadable or misnamed, about modules that import each
    other, and about test files. *)

open Basis

val diagnostic : Resolve.Fact.in_modules -> Diagnostic.t
