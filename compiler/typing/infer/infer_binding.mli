(** Bindings: right sides, local declarations, functions.

    Local bindings generalize only if they are functions with a signature; a local value with a
    polymorphic signature is [E0314]. *)

open Basis
open Context

val abstraction :
  t ->
  at:Span.t ->
  name:string option ->
  Resolve.Ir.pattern list ->
  Expected.t ->
  (Expected.t -> Ir.expr later) ->
  Ir.expr later
(** A function of parameters, given how its body is checked; [name] if it is a definition. Without
    parameters the body itself. *)

val right : expressions -> t -> Resolve.Ir.right -> Expected.t -> Ir.expr later
(** Guards under their [where]. *)

val declarations : expressions -> t -> Resolve.Ir.declarations -> Ir.binding list later
(** Local ones; their names have types afterwards. *)

val annotated : expressions -> t -> Resolve.Ir.expr -> Resolve.Ir.expr -> Resolve.Ir.scheme -> typed
(** [(e :: T)]: as a local binding with that signature. *)

val undecided : Expected.t -> bool
(** Is any type right, or a task with any result? *)

val beside : undecided:bool -> Expected.t -> Span.t -> Expected.t
(** What is expected of the branches after one at that place; [undecided] before that one. *)
