(** Labels for the expressions that require a class. *)

open Basis
open Typing

val add : Wording.t -> Instance_fact.required -> Diagnostic.t -> Diagnostic.t
(** Labels the place that imposes the constraint. *)

val user : Wording.t -> Instance_fact.required -> string
(** The expression or construct that requires the class, in backticks. *)
