(** Messages about switches and tasks that may follow each other endlessly within one instant
    ([E0402]). *)

open Basis

val diagnostic :
  at:Span.t ->
  entry:Span.t ->
  Flow.Ir.program ->
  Flow.Fact.step list ->
  limit:int option ->
  Diagnostic.t
