(** Small changes to a formula, such as [integral] for [derivative], that give it the expected unit.
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
(** Suggests [integral x] for [derivative x] or the reverse, or the base in place of its power, also
    in the definitions of the names in the formula. If [elsewhere], considers only an integral or a
    derivative that is part of a larger formula or of a definition, because it is then very likely
    the mistake. Otherwise, considers only the other changes. *)

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
(** A field of a record whose expected unit comes from another field, which has an extra power. *)

val of_a_record :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A record with the wrong unit in one field and the expected unit in the others. *)
