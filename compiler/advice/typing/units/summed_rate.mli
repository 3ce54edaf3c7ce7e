(** A rate that an equation adds up by itself, such as [x = delay 0 x + 0.02 * v], where [integral]
    was meant. *)

open Basis
open Typing

val complete :
  Wording.t ->
  subject:Resolve.Ir.expr option ->
  expected:Expected.t ->
  Units.t * Units.t ->
  (Diagnostic.t -> Diagnostic.t) option
(** Completes the message about two units that differ by a time. *)
