(** Small changes of a formula, such as [integral] for [derivative], that give it the expected unit.
    A change is suggested only if it is the only one that does so. Each pair of units contains the
    expected unit and the actual one. *)

open Basis
open Typing

val suggest :
  Wording.t ->
  elsewhere:bool ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** [integral x] for [derivative x] or the reverse, or a base without its power, also in the
    definitions of the names in the formula. If [elsewhere], only operations that are part of a
    larger formula or of a definition, because then the operation is very likely the mistake;
    otherwise, only the other changes. *)

val exchanged_angle :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** [angle * sin distance], meant as [distance * sin angle]. *)

val of_a_field :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** The field of a record where another field, which determines the unit, has a power too many. *)

val of_a_record :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A record of the wrong unit, of which some fields have the expected unit. *)
