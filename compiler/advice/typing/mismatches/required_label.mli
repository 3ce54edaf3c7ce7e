(** The label that shows why a class is required. *)

open Basis
open Typing

val add : Show.words -> Instance_fact.required -> Diagnostic.t -> Diagnostic.t
