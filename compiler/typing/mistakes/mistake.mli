(** What is said about types that do not fit, in the words of the program.

    One module for each kind of clash: {!Number_mistake}, {!Signature_mistake}, {!Shape_mistake}
    with {!Task_mistake} and {!Output_mistake}. Here they are told apart, and the rest is said:
    [E0301] a negative argument without parentheses · [E0302] not a function, or too many arguments
    · [E0304] no signal function before [-<] · [E0305] an infinite type · [E0306] a signature whose
    variable depends on what is outside · [E0316] too large a type · [E0323] exponents. *)

open Basis

val mismatch :
  Show.words ->
  Signature_mistake.owner ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:Expected.t ->
  found:Type.t ->
  Unify.clash ->
  Diagnostic.t
(** [subject] is the expression at fault, if it is one. The clash is that of
    [Unify.types expected found]. *)

val exchanged_pair :
  Show.words ->
  at:Span.t ->
  Expected.t ->
  Resolve.Ir.expr * Type.t ->
  Resolve.Ir.expr * Type.t ->
  Diagnostic.t
(** E0301: the two of a pair stand in the other order. *)

val not_a_function :
  Show.words -> head:Resolve.Ir.expr -> position:int -> at:Span.t -> Type.t -> Diagnostic.t
(** What is left of the head's type cannot take the argument of that number. *)

val applied_without_parentheses :
  name:string -> inner:string -> whole:string -> Diagnostic.t -> Diagnostic.t
(** The diagnostic of an application that has too many arguments, as a function among them was to be
    applied to others: [inner], so that it should be [whole]. *)

val negative_argument :
  Show.words ->
  minus:Span.t ->
  operand:Resolve.Ir.expr option ->
  Resolve.Ir.expr ->
  Type.t ->
  Diagnostic.t
(** [f -1], where [f] is a function of that type; [operand] is what follows the minus. *)

val not_a_signal_function : Show.words -> head:Resolve.Ir.expr -> Type.t -> Diagnostic.t
(** The head of [sf -< e]. *)

val too_large : at:Span.t -> string -> Diagnostic.t
(** {!Final.Too_large}, of the type of what is named here. *)
