(** Messages about operators that need parentheses, and about exponents. They quote the source text.
*)

open Basis
open Syntax
open Syntax.Ir

val exponent :
  text:string -> base:Surface.term -> operator:qualified -> Surface.term -> Diagnostic.t
(** An exponent that is not a literal whole number. *)

val two_operators :
  text:string ->
  compare:bool ->
  Surface.term ->
  qualified ->
  Surface.term ->
  qualified ->
  Surface.term ->
  Diagnostic.t
(** [a < b < c] *)

val minus_after : operator:qualified -> at:Span.t -> Surface.term -> Diagnostic.t
(** [x * -y]; the last argument is the operand of the minus sign. *)

val two_minuses : first:Span.t -> second:Span.t -> Surface.term -> Diagnostic.t
val section : qualified -> inner:qualified option -> Diagnostic.t
