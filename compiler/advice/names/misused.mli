(** Units, fields and sizes that are used as values. *)

open Basis
open Syntax.Ir

val size : Resolve.Fact.size -> name -> Diagnostic.t
val unit_of_a_value : head:expr -> unit_:expr -> at:Span.t -> Diagnostic.t
val unit_apart : head:expr -> unit_:expr -> at:Span.t -> Diagnostic.t
val field : whole:Span.t -> field:name -> record:name -> Diagnostic.t
