(** Messages about a robot that lacks a capability. *)

open Typing

val lacking :
  Wording.t ->
  user:string ->
  at:Basis.Span.t ->
  Ir.class_ ->
  of_:Type.t ->
  (Basis.Diagnostic.t -> Basis.Diagnostic.t) option
(** Completes the message at this place if [of_] is the input or output of a robot, which lacks the
    capability that the class represents. Suggests a robot of the library that has it. *)
