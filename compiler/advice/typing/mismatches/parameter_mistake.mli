(** Messages about definitions whose parameters do not fit their signature ([E0301], [E0302]). The
    functions take the arguments of the facts in {!Typing.Inference_fact.t}. *)

open Basis
open Typing

val too_many :
  Wording.t ->
  name:string option ->
  at:Span.t ->
  parameters:Resolve.Ir.pattern list ->
  Expected.t ->
  result:Type.t ->
  int ->
  Diagnostic.t
(** More parameters than the type allows. *)

val in_a_tuple :
  Wording.t -> name:string -> at:Span.t -> Resolve.Ir.pattern list -> Expected.t -> Diagnostic.t
(** A tuple in place of separate parameters. *)

val lacking_types :
  Wording.t -> name:string -> at:Span.t -> Expected.t -> (string * Type.t) list -> Diagnostic.t
(** A signature without the types of some parameters. *)

val refutable_input : pattern:Resolve.Ir.pattern -> Type.t -> Diagnostic.t -> Diagnostic.t
(** Completes the message about the pattern [()] for an input of this type. *)
