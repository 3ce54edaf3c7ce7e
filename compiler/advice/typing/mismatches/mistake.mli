(** Messages about mismatched types, in terms of the user's program.

    Each kind of clash has a module: {!Number_mistake}, {!Signature_mistake}, and {!Shape_mistake}
    with {!Task_mistake} and {!Output_mistake}. This module selects one of them, and reports the
    remaining errors: [E0305] an infinite type · [E0306] a signature whose variable depends on an
    outer type · [E0316] a type that is too large · [E0323] an exponent out of range · [E0413] too
    many record updates. Messages about the head of an application are in {!Head_mistake}. *)

open Basis
open Typing

val mismatch : Wording.t -> Inference_fact.mismatch -> Diagnostic.t

val exchanged_pair :
  Wording.t ->
  at:Span.t ->
  Expected.t ->
  Resolve.Ir.expr * Type.t ->
  Resolve.Ir.expr * Type.t ->
  Diagnostic.t
(** The message E0301 about a pair with swapped components. *)

val exponent_too_large : at:Span.t -> Diagnostic.t
val too_large : at:Span.t -> Fact.construct -> Diagnostic.t

val too_many_updates : at:Span.t -> Ir.constructor -> updates:int -> most_fields:int -> Diagnostic.t
(** See {!Fact.Too_many_updates}. *)
