(** What requires a class, and why. *)

open Basis
open Typing

val add : Show.words -> Instance_fact.required -> Diagnostic.t -> Diagnostic.t
(** Labels the place that imposes the constraint. *)

val user : Show.words -> Instance_fact.required -> string
(** What requires the class, in backticks. *)
