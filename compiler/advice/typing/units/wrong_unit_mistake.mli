(** Wrong units in the source: a superfluous factor such as [1[m]], and a gain, a constant or a
    parameter whose use requires a different unit. Each pair of units contains the expected unit and
    the actual one. *)

open Basis
open Typing

val superfluous_factor :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** [sqrt (x ^ 2 + y ^ 2) * 1[m]] where a length is needed. *)

val superfluous_function :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** [integral v] or [derivative x] where [v] or [x] is needed. *)

val gain :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A term with a gain of the wrong unit: [4[rad/(m s)] * e + 2[rad/(m s)] * derivative e]. *)

val constant :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A name that is defined as a number with the wrong unit. *)

val bare_parameter :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A factor that is a parameter, whose type in the signature has no unit. *)

val parameter :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** A parameter whose type in the signature has the wrong unit. *)
