(** Messages about terms that cannot be used as a pattern, an expression or the left-hand side of a
    definition. *)

open Basis
open Syntax
open Syntax.Ir

val unit_after_space :
  number:Surface.term -> digits:string -> unit_:Surface.term list -> Span.t -> Diagnostic.t

val wildcard : Span.t -> Diagnostic.t
val as_pattern : at:Span.t -> name -> Diagnostic.t

(** {1 Patterns} *)

val qualified : at:Span.t -> qualifier:name -> name -> Diagnostic.t
val operator : at:Span.t -> name -> Diagnostic.t
val empty_array : Span.t -> Diagnostic.t
val application : Span.t -> Diagnostic.t
val braces : Span.t -> Diagnostic.t
val minus : Span.t -> Diagnostic.t
val expression : Span.t -> expr_desc -> Diagnostic.t

(** {1 Left-hand sides} *)

val minus_in_name : at:Span.t -> left:name -> right:name -> Diagnostic.t
val operator_on_left : text:string -> qualified -> Diagnostic.t
val parentheses_on_left : Span.t -> Diagnostic.t
