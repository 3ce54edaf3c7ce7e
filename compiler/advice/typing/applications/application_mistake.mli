(** Messages about a whole application in which one argument has the wrong type. *)

open Basis
open Typing

val explain : Wording.t -> Application_fact.call -> Fact.t Facts.held -> Diagnostic.t
(** Completes or replaces the message about the failing argument, if the application explains the
    mistake better. *)

val parameters_in_other_order :
  Wording.t ->
  head:Resolve.Ir.expr ->
  name:string ->
  Resolve.Ir.pattern ->
  Resolve.Ir.pattern ->
  Diagnostic.t
(** The message [E0301] about [foldl (\x n -> n + x) 0 xs]. *)

val mapped_range : Wording.t -> at:Span.t -> head:Span.t -> Resolve.Ir.expr list -> Diagnostic.t
(** The message [E0301] about [map x 0 1023 0 255]. *)
