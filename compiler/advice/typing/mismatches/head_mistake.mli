(** Messages about the head of an application: [E0301] a negative argument without parentheses ·
    [E0302] not a function, or too many arguments · [E0304] not a signal function before [-<]. *)

open Basis
open Typing

val not_a_function :
  Wording.t ->
  head:Resolve.Ir.expr ->
  position:int ->
  given:int ->
  argument:Resolve.Ir.expr ->
  Type.t ->
  Diagnostic.t
(** The message about a head that cannot take the argument at this position. The last argument is
    the type of the head applied to the preceding arguments. *)

val applied_without_parentheses :
  name:string -> runs_a_task:bool -> inner:string -> whole:string -> Diagnostic.t -> Diagnostic.t
(** Rewrites the message about an application with too many arguments: the parentheses around
    [inner] are missing, and the corrected application is [whole]. [runs_a_task]: the head of
    [inner] returns a task. *)

val negative_argument :
  Wording.t ->
  minus:Span.t ->
  operand:Resolve.Ir.expr option ->
  Resolve.Ir.expr ->
  Type.t ->
  Diagnostic.t
(** The message about [f -1], where [f] is a function of the given type. [operand]: the expression
    after the minus sign. *)

val not_a_signal_function : Wording.t -> head:Resolve.Ir.expr -> Type.t -> Diagnostic.t
(** The message about the head of [sf -< e]. *)
