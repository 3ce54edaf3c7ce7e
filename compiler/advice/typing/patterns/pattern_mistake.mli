(** Messages about patterns: a `case` that does not cover every value ([E0350]) or is too complex to
    check ([E0413]), a pattern that must match every value ([E0351]), guards that can all be false
    ([E0352]), and a branch that is never taken ([W0301]). *)

open Basis

val diagnostic : Source.t -> Typing.Pattern_fact.t -> Diagnostic.t

val matched_twice :
  Typing.Ir.Global.t ->
  first:Resolve.Ir.pattern ->
  second:Resolve.Ir.pattern ->
  missing:string ->
  Diagnostic.t
(** The message [E0301] about two branches for the same constructor. *)
