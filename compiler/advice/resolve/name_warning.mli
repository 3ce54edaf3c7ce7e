(** Warnings about hidden, unused and deprecated names. *)

open Basis

val diagnostic : Resolve.Fact.warning -> Diagnostic.t
