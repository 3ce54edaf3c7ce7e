(** An equation that adds up a rate without [integral], such as [x = delay 0 x + 0.02 * v]. *)

open Basis
open Typing

val complete :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** Completes the message about two units that differ by a time. *)
