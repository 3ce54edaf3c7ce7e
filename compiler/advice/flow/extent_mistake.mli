(** Messages about programs that store too many values or run too many signal functions ([E0413]).
*)

open Basis

val diagnostic :
  entry:Span.t ->
  Flow.Fact.measure ->
  amount:float ->
  limit:float ->
  Flow.Fact.part list ->
  Diagnostic.t
