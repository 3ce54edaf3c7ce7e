(** Modules that are missing, unreadable, misnamed or import each other, and test files. *)

open Basis

val diagnostic : Resolve.Fact.in_modules -> Diagnostic.t
