(** Rules about expressions whose unit differs from the expected one. *)

open Basis
open Typing

type complete = Diagnostic.t -> Diagnostic.t
(** Adds labels, hints and fixes to the message about the units. *)

type t =
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  complete option
(** The pair contains the expected unit and the actual one. [subject] is the expression that has the
    wrong unit, if there is one. The result is [None] if the rule does not apply. *)

type in_any_context =
  Wording.t -> subject:Resolve.Ir.expr option -> Units.t * Units.t -> complete option
(** A rule that depends only on the expression and the units. *)
