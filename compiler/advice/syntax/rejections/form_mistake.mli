(** Messages about malformed declarations and units. *)

open Basis
open Syntax.Ir

val context : Span.t -> Diagnostic.t
val class_head : Span.t -> Diagnostic.t
val superclass : at:Span.t -> class_:name -> name -> Diagnostic.t
val instance_head : Span.t -> Diagnostic.t
val foreign_word : expected:string -> name -> Diagnostic.t
val size : at:Span.t -> string -> Diagnostic.t
val size_operator : text:string -> at:Span.t -> string -> Diagnostic.t
val empty_where : Span.t -> Diagnostic.t

(** {1 Units} *)

val number_in_unit : text:string -> at:Span.t -> string -> Diagnostic.t
val exponent_not_whole : at:Span.t -> string -> Diagnostic.t
val exponent_too_large : Span.t -> Diagnostic.t
val exponent_over_zero : Span.t -> Diagnostic.t
val scale : Span.t -> Diagnostic.t
